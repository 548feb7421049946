#include "interrupt.h"

#include <pthread.h>
#include <signal.h>

#include <thread>

namespace lambert::cli {

std::stop_token stop_on_interrupt() {
  static std::stop_source source;
  // A thread that waits for the signals, since request_stop() may not be called from a signal handler.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int which = 0;
    sigwait(&signals, &which);
    source.request_stop();
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }).detach();
  return source.get_token();
}

}  // namespace lambert::cli
