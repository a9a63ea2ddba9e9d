#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace mien::pipeline {

/// How often something may be done: `burst` times at once, then `per_second` times.
struct Rate {
  double burst = 100;
  double per_second = 10;
};

/// Counts how often each of many does it (token buckets). For several threads.
class RateLimit {
 public:
  using Clock = std::chrono::steady_clock;

  explicit RateLimit(Rate rate) : rate_(rate) {}

  /// Whether it may be done once more; if so, it is counted.
  bool allows(const std::string& who, Clock::time_point now = Clock::now());

 private:
  struct Bucket {
    double left = 0;
    Clock::time_point filled;
  };

  void forget_full(Clock::time_point now);
  double left(const Bucket& bucket, Clock::time_point now) const;

  Rate rate_;
  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace mien::pipeline
