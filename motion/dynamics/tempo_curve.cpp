#include "motion/dynamics/tempo_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mien::motion {

namespace {

constexpr double slowest = 0.25;
constexpr double fastest = 4.0;

bool is_in_range(double factor) { return factor >= slowest && factor <= fastest; }

std::string plain(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

/// The points of a curve by the logarithm of their factors; of a loop with the neighbours of its
/// first and last points, so that every moment lies between two of them.
std::vector<TempoPoint> knots_of(const Tempo& tempo, bool loops) {
  std::vector<TempoPoint> knots = tempo.curve;
  for (TempoPoint& knot : knots) knot.factor = std::log(knot.factor);
  if (!loops) return knots;
  if (knots.size() > 1 && knots.front().share == 0.0 && knots.back().share == 1.0) {
    knots.front().factor = 0.5 * (knots.front().factor + knots.back().factor);
    knots.pop_back();
  }
  const std::vector<TempoPoint> one_round = knots;
  std::vector<TempoPoint> round;
  for (int lap = -2; lap <= 2; ++lap) {
    for (const TempoPoint& knot : one_round) round.push_back({knot.share + lap, knot.factor});
  }
  return round;
}

/// Rise per share from one knot to the next.
double rise(const std::vector<TempoPoint>& knots, std::size_t i) {
  return (knots[i + 1].factor - knots[i].factor) / (knots[i + 1].share - knots[i].share);
}

/// The slope at a knot: the harmonic mean of the rises on both sides, 0 where the curve turns and
/// at open ends.
double slope(const std::vector<TempoPoint>& knots, std::size_t i) {
  if (i == 0 || i + 1 == knots.size()) return 0.0;
  const double before = rise(knots, i - 1);
  const double after = rise(knots, i);
  return before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
}

}  // namespace

bool is_unit(const Tempo& tempo) {
  if (tempo.curve.empty()) return tempo.factor == 1.0;
  return std::all_of(tempo.curve.begin(), tempo.curve.end(),
                     [](const TempoPoint& point) { return point.factor == 1.0; });
}

double factor_at(const Tempo& tempo, double share, bool loops) {
  if (tempo.curve.empty()) return tempo.factor;
  const std::vector<TempoPoint> knots = knots_of(tempo, loops);
  if (loops) share -= std::floor(share);
  const auto after = std::find_if(knots.begin(), knots.end(),
                                  [&](const auto& knot) { return knot.share > share; });
  if (after == knots.begin()) return std::exp(knots.front().factor);
  if (after == knots.end()) return std::exp(knots.back().factor);
  const auto i = static_cast<std::size_t>(after - knots.begin()) - 1;
  const TempoPoint &a = knots[i], &b = knots[i + 1];
  const double width = b.share - a.share;
  const double t = (share - a.share) / width;
  const double u = 1.0 - t;
  return std::exp(u * u * (1.0 + 2.0 * t) * a.factor + t * t * (3.0 - 2.0 * t) * b.factor +
                  width * t * u * (u * slope(knots, i) - t * slope(knots, i + 1)));
}

Tempo scaled(const Tempo& tempo, double strength) {
  const auto at_strength = [&](double factor) {
    return std::clamp(std::pow(factor, strength), slowest, fastest);
  };
  Tempo result = tempo;
  result.factor = at_strength(tempo.factor);
  for (TempoPoint& point : result.curve) point.factor = at_strength(point.factor);
  return result;
}

TempoFault fault_of(const Tempo& tempo) {
  if (tempo.curve.empty()) {
    if (is_in_range(tempo.factor)) return {};
    return {"tempo is " + plain(tempo.factor), "give a number from 0.25 to 4", -1, true};
  }
  double before = -1.0;
  for (std::size_t i = 0; i < tempo.curve.size(); ++i) {
    const TempoPoint& point = tempo.curve[i];
    const int index = static_cast<int>(i);
    if (!(point.share >= 0.0 && point.share <= 1.0)) {
      return {"the moment " + plain(point.share) + " is not in the motion",
              "give a share of its duration, from 0 (beginning) to 1 (end)", index};
    }
    if (!is_in_range(point.factor)) {
      return {"the speed factor is " + plain(point.factor), "give a number from 0.25 to 4", index,
              true};
    }
    if (point.share <= before) {
      return {"the moment " + plain(point.share) + " does not follow " + plain(before),
              "give the points of the curve in the order of their moments, each once", index};
    }
    before = point.share;
  }
  return {};
}

std::string text_of(const Tempo& tempo) {
  if (tempo.curve.empty()) return plain(tempo.factor);
  std::string text;
  for (const TempoPoint& point : tempo.curve) {
    text += (text.empty() ? "" : " → ") + plain(point.factor);
  }
  return text;
}

}  // namespace mien::motion
