#include "pipeline/study/server/rate_limit.h"

#include <algorithm>

namespace mien::pipeline {

namespace {

/// More clients than a laboratory has; beyond this, full buckets are removed.
constexpr std::size_t max_buckets = 10000;

}  // namespace

double RateLimit::tokens_at(const Bucket& bucket, Clock::time_point now) const {
  const double seconds = std::chrono::duration<double>(now - bucket.filled).count();
  return std::min(rate_.burst, bucket.tokens + std::max(0.0, seconds) * rate_.per_second);
}

void RateLimit::remove_full_buckets(Clock::time_point now) {
  std::erase_if(buckets_,
                [&](const auto& one) { return tokens_at(one.second, now) >= rate_.burst; });
}

bool RateLimit::allows(const std::string& client, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (buckets_.size() >= max_buckets && !buckets_.contains(client)) {
    remove_full_buckets(now);
    if (buckets_.size() >= max_buckets) return false;
  }
  const auto found = buckets_.try_emplace(client, Bucket{rate_.burst, now}).first;
  found->second.tokens = tokens_at(found->second, now);
  found->second.filled = now;
  if (found->second.tokens < 1) return false;
  found->second.tokens -= 1;
  return true;
}

}  // namespace mien::pipeline
