#include "pipeline/manifest/ratings/answers/trace.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "motion/text/as_number.h"

namespace mien::pipeline {

namespace {

/// Durations are not exact in binary: what is hardly longer than 3 s has no further sample.
constexpr double rounding_slack = 1e-6;

/// "0", "7.5", "100": digits, and at most one decimal.
std::optional<double> sample_of(std::string_view text) {
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const bool is_plain = text.find_first_not_of("0123456789.") == std::string_view::npos &&
                        !whole.empty() && whole.size() <= 3 &&
                        (point == std::string_view::npos || text.size() == point + 2);
  const auto number = is_plain ? motion::as_finite_number(text) : std::nullopt;
  return number && *number <= 100.0 ? number : std::nullopt;
}

}  // namespace

std::size_t trace_samples(double seconds) {
  return static_cast<std::size_t>(std::ceil(seconds * trace_rate_hz - rounding_slack)) + 1;
}

double sample_time(std::size_t sample, double film_seconds) {
  const double time = static_cast<double>(sample) / trace_rate_hz;
  return film_seconds > 0.0 ? std::min(time, film_seconds) : time;
}

std::size_t longest_trace_text() {
  return std::string_view("99.9 ").size() * trace_samples(longest_trace_seconds);
}

std::optional<std::vector<double>> read_trace(std::string_view text) {
  std::vector<double> trace;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const auto sample = sample_of(text.substr(begin, end - begin));
    if (!sample) return std::nullopt;
    trace.push_back(*sample);
    begin = end + 1;
  }
  return trace;
}

std::string to_text(const std::vector<double>& trace) {
  std::string text;
  for (const double sample : trace) {
    const auto tenths = std::lround(10.0 * sample);
    if (!text.empty()) text += ' ';
    text += std::to_string(tenths / 10);
    if (tenths % 10 != 0) text += fmt::format(".{}", tenths % 10);
  }
  return text;
}

std::size_t first_sample_from(double seconds) {
  return static_cast<std::size_t>(
      std::max(0.0, std::ceil(seconds * trace_rate_hz - rounding_slack)));
}

std::optional<double> mean_of_trace(const std::vector<double>& trace, double lead, double lag) {
  const std::size_t first = first_sample_from(lead + lag);
  if (first >= trace.size()) return std::nullopt;
  const double sum =
      std::accumulate(trace.begin() + static_cast<std::ptrdiff_t>(first), trace.end(), 0.0);
  return sum / static_cast<double>(trace.size() - first);
}

}  // namespace mien::pipeline
