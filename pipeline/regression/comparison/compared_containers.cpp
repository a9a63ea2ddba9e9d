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

void note_number_change(std::vector<std::string>& lines, const std::string& what, double before,
                        double now) {
  const auto [was, is] = distinct_numbers(before, now);
  lines.push_back(fmt::format("{}: {} → {}", what, was, is));
}

/// The first frame that is shown at another moment, counted from the first.
void compare_moments(const VideoSummary& before, const VideoSummary& now, double unit,
                     std::vector<std::string>& remarks) {
  if (before.times.size() != now.times.size()) return;
  for (std::size_t i = 0; i < before.times.size(); ++i) {
    const double was = before.times[i] - before.times[0], is = now.times[i] - now.times[0];
    if (std::abs(was - is) <= unit) continue;
    note_number_change(remarks, fmt::format("time of frame {}, in seconds", i), was, is);
    return;
  }
}

void note_word_change(std::vector<std::string>& lines, const char* what, const std::string& before,
                      const std::string& now) {
  if (before != now) lines.push_back(fmt::format("{}: {} → {}", what, before, now));
}

}  // namespace

void compare_containers(const VideoSummary& before, const VideoSummary& now,
                        std::vector<std::string>& remarks, std::vector<std::string>& notes) {
  constexpr double arithmetic = 1e-9;
  const double unit = before.tick_seconds + now.tick_seconds + arithmetic;
  const double rate_before = before.rate.per_second(), rate_now = now.rate.per_second();
  if (is_rate(rate_before, rate_now))
    compare_moments(before, now, unit, remarks);
  else
    note_number_change(remarks, "frames per second", rate_before, rate_now);
  if (std::abs(before.duration_seconds - now.duration_seconds) > unit)
    note_number_change(remarks, "duration in seconds", before.duration_seconds,
                       now.duration_seconds);
  note_word_change(remarks, "primaries", before.primaries, now.primaries);
  note_word_change(remarks, "transfer", before.transfer, now.transfer);
  note_word_change(remarks, "matrix", before.matrix, now.matrix);
  note_word_change(remarks, "range", before.range, now.range);
  note_word_change(notes, "codec", before.codec, now.codec);
  note_word_change(notes, "pixel format", before.pixel_format, now.pixel_format);
}

}  // namespace mien::pipeline
