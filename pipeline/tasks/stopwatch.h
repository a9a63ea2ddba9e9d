#pragma once

#include <chrono>
#include <mutex>

namespace mien::pipeline {

/// Measures the wall time during which at least one thread is inside a section.
class Stopwatch {
 public:
  /// Marks a section by its lifetime. Does nothing if `watch` is null.
  class Running {
   public:
    explicit Running(Stopwatch* watch) : watch_(watch) {
      if (watch_ != nullptr) watch_->enter();
    }
    ~Running() {
      if (watch_ != nullptr) watch_->leave();
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

   private:
    Stopwatch* watch_;
  };

  /// Time so far, seconds. While any thread is inside a section, the current period is not included
  /// yet.
  double seconds() const {
    const std::lock_guard lock(mutex_);
    return std::chrono::duration<double>(total_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void enter() {
    const std::lock_guard lock(mutex_);
    if (inside_++ == 0) since_ = Clock::now();
  }

  void leave() {
    const std::lock_guard lock(mutex_);
    if (--inside_ == 0) total_ += Clock::now() - since_;
  }

  mutable std::mutex mutex_;
  int inside_ = 0;
  Clock::time_point since_;
  Clock::duration total_{};
};

}  // namespace mien::pipeline
