#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/regression/comparison/compared_media.h"
#include "pipeline/regression/comparison/distinct_numbers.h"

namespace mien::pipeline {

namespace {

using render::VideoSummary;

/// Rates that containers round to their own unit of time are the same.
bool is_rate(double before, double now) {
  constexpr double rounding = 1e-5;
  return std::abs(before - now) <= rounding * std::max(before, now);
}

void tell_numbers(std::vector<std::string>& told, const std::string& what, double before,
                  double now) {
  const auto [was, is] = distinct_numbers(before, now);
  told.push_back(fmt::format("{}: {} → {}", what, was, is));
}

/// The first frame that is shown at another moment, counted from the first.
void compare_moments(const VideoSummary& before, const VideoSummary& now, double unit,
                     std::vector<std::string>& seen) {
  if (before.times.size() != now.times.size()) return;
  for (std::size_t i = 0; i < before.times.size(); ++i) {
    const double was = before.times[i] - before.times[0], is = now.times[i] - now.times[0];
    if (std::abs(was - is) <= unit) continue;
    tell_numbers(seen, fmt::format("time of frame {}, in seconds", i), was, is);
    return;
  }
}

void tell_words(std::vector<std::string>& told, const char* what, const std::string& before,
                const std::string& now) {
  if (before != now) told.push_back(fmt::format("{}: {} → {}", what, before, now));
}

}  // namespace

void compare_containers(const VideoSummary& before, const VideoSummary& now,
                        std::vector<std::string>& seen, std::vector<std::string>& kept) {
  constexpr double arithmetic = 1e-9;
  const double unit = before.tick_seconds + now.tick_seconds + arithmetic;
  const double rate_before = before.rate.per_second(), rate_now = now.rate.per_second();
  if (is_rate(rate_before, rate_now))
    compare_moments(before, now, unit, seen);
  else
    tell_numbers(seen, "frames per second", rate_before, rate_now);
  if (std::abs(before.duration_seconds - now.duration_seconds) > unit)
    tell_numbers(seen, "duration in seconds", before.duration_seconds, now.duration_seconds);
  tell_words(seen, "primaries", before.primaries, now.primaries);
  tell_words(seen, "transfer", before.transfer, now.transfer);
  tell_words(seen, "matrix", before.matrix, now.matrix);
  tell_words(seen, "range", before.range, now.range);
  tell_words(kept, "codec", before.codec, now.codec);
  tell_words(kept, "pixel format", before.pixel_format, now.pixel_format);
}

}  // namespace mien::pipeline
