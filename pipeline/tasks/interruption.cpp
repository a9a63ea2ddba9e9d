#include "pipeline/tasks/interruption.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <pthread.h>

#include "motion/text/result_file.h"

namespace mien::pipeline {

namespace {

constexpr int exit_interrupted = 130;

sigset_t watched_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

SignalWatch::SignalWatch() {
  const sigset_t signals = watched_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  thread_ = std::thread([this] { watch(); });
}

SignalWatch::~SignalWatch() {
  closing_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
}

void SignalWatch::watch() {
  const sigset_t signals = watched_signals();
  int signal = 0;
  while (sigwait(&signals, &signal) == 0 && !closing_) {
    if (source_.request_stop()) {
      std::fputs("\ninterrupted: stopping; finished work is kept (Ctrl-C to stop at once)\n",
                 stderr);
    } else if (signal == SIGINT) {
      motion::remove_unfinished_results();
      std::_Exit(exit_interrupted);
    }
  }
}

}  // namespace mien::pipeline
