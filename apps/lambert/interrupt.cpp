#include "interrupt.h"

#include "command.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <thread>

namespace lambert::cli {

std::stop_token stop_on_interrupt() {
  // The thread shares the state of `source`, so that a signal may come at any time, even while main() returns.
  std::stop_source source;
  std::stop_token token = source.get_token();
  // A thread that waits for the signals, since request_stop() may not be called from a signal handler.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, source]() mutable {
    int which = 0;
    sigwait(&signals, &which);
    source.request_stop();
    sigwait(&signals, &which);
    ::_exit(interrupted);
  }).detach();
  return token;
}

}  // namespace lambert::cli
