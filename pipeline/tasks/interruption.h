#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace mien::pipeline {

/// Turns SIGINT and SIGTERM into a stop request and reports it on standard error. After that,
/// SIGINT ends the program at once with exit code 130; SIGTERM does not, because batch systems send
/// it to a job more than once. Must be created before any other thread, because it blocks these
/// signals for later threads and waits for the signals in a thread of its own.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  void watch();

  std::stop_source source_;
  std::atomic<bool> closing_ = false;
  std::thread thread_;
};

}  // namespace mien::pipeline
