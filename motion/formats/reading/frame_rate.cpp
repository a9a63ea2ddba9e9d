#include "motion/formats/reading/frame_rate.h"

#include <array>
#include <cmath>
#include <span>

namespace mien::motion {

namespace {

constexpr double whole_rates[] = {10,  12,  12.5, 15,  20,  24,  25,  30,  40,  48,
                                  50,  60,  72,   75,  80,  90,  100, 120, 125, 144,
                                  150, 200, 240,  250, 300, 360, 400, 480, 500, 1000};
constexpr double ntsc_rates[] = {24000.0 / 1001.0, 30000.0 / 1001.0, 60000.0 / 1001.0,
                                 120000.0 / 1001.0};

/// The rate whose period is nearest to `seconds`, no farther than `most` away; 0 for none.
double nearest_rate(std::span<const double> rates, double seconds, double most) {
  double best = 0.0;
  double smallest = most * (1.0 + 1e-9);
  for (const double rate : rates) {
    const double gap = std::abs(1.0 / rate - seconds);
    if (gap > smallest) continue;
    smallest = gap;
    best = rate;
  }
  return best;
}

}  // namespace

double frame_rate_of_period(double seconds, int decimals) {
  const double last_digit = std::pow(10.0, -decimals);
  for (const std::span<const double> rates : {std::span<const double>(whole_rates), {ntsc_rates}}) {
    const double rate = nearest_rate(rates, seconds, 0.5 * last_digit);
    if (decimals > 0 && rate > 0.0) return rate;
  }
  return snapped_frame_rate(1.0 / seconds);
}

double frame_rate_of_period(double seconds, std::string_view written) {
  const size_t point = written.find('.');
  const bool is_plain = written.find_first_of("eE") == std::string_view::npos;
  const bool has_decimals = is_plain && point != std::string_view::npos;
  return frame_rate_of_period(seconds,
                              has_decimals ? static_cast<int>(written.size() - point - 1) : 0);
}

double snapped_frame_rate(double frames_per_second) {
  constexpr double tolerance = 0.001 + 1e-9;
  const std::array<double, 5> candidates = {std::round(frames_per_second), 24000.0 / 1001.0,
                                            30000.0 / 1001.0, 60000.0 / 1001.0, 120000.0 / 1001.0};
  double best = frames_per_second;
  double smallest = tolerance;
  for (const double candidate : candidates) {
    // Relative to the frame time, the number that was rounded when the file was written.
    const double gap = std::abs(candidate / frames_per_second - 1.0);
    if (candidate > 0.0 && gap <= smallest) {
      best = candidate;
      smallest = gap;
    }
  }
  return best;
}

}  // namespace mien::motion
