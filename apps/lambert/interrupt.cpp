#include "interrupt.h"

#include "command.h"

#include "lambert/base/file.h"

#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <string_view>
#include <thread>

namespace lambert::cli {
namespace {

struct Waiting {
  std::stop_source source;
  std::atomic<bool> stops = false;  ///< the work ends itself
};
/// Never destroyed, so that a signal may come at any time, even while main() returns.
Waiting& waiting() {
  static Waiting& all = *new Waiting;
  return all;
}

/// Unless standard error takes no more: the process must end.
void say(std::string_view words) {
  pollfd to{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
  if (::poll(&to, 1, 0) == 1 && (to.revents & POLLOUT) != 0) [[maybe_unused]]
    const ssize_t ignored = ::write(STDERR_FILENO, words.data(), words.size());
}

/// As by nohup.
bool is_ignored(int which) {
  struct sigaction action {};
  return ::sigaction(which, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// The reader of what this thread is writing went away. Nothing is written while the list of files is locked, so this
/// may do what other signal handlers may not.
void end_by_broken_pipe(int which) {
  abandon_files();
  ::signal(which, SIG_DFL);
  ::raise(which);
}

}  // namespace

void end_on_interrupt() {
  ::signal(SIGPIPE, end_by_broken_pipe);
  // A thread that waits for the signals, since little may be called from a signal handler.
  sigset_t signals;
  sigemptyset(&signals);
  for (const int which : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(which)) sigaddset(&signals, which);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int which = 0;
    sigwait(&signals, &which);
    if (waiting().stops) {
      waiting().source.request_stop();
      sigwait(&signals, &which);
      abandon_files();
      ::_exit(interrupted);
    }
    say(abandon_files() ? "lambert: warning: interrupted; what was not finished is not written\n"
                        : "lambert: warning: interrupted; nothing is written\n");
    ::_exit(interrupted);
  }).detach();
}

std::stop_token stop_on_interrupt() {
  waiting().stops = true;
  return waiting().source.get_token();
}

}  // namespace lambert::cli
