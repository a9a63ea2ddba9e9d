#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace mien::pipeline {

/// A permitted rate: `burst` events at once, then `per_second` events per second.
struct Rate {
  double burst = 100;
  double per_second = 10;
};

/// Limits the rate of each client by a token bucket. Thread-safe.
class RateLimit {
 public:
  using Clock = std::chrono::steady_clock;

  explicit RateLimit(Rate rate) : rate_(rate) {}

  /// Takes a token from the client's bucket. Returns false if the bucket is empty, or if there are
  /// already 10 000 other buckets that are not full.
  bool allows(const std::string& client, Clock::time_point now = Clock::now());

 private:
  struct Bucket {
    double tokens = 0;  ///< at the time `filled`
    Clock::time_point filled;
  };

  void remove_full_buckets(Clock::time_point now);
  double tokens_at(const Bucket& bucket, Clock::time_point now) const;

  Rate rate_;
  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace mien::pipeline
