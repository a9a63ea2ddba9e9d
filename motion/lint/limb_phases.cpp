#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/lint/against_original.h"
#include "motion/lint/checks.h"
#include "motion/lint/stretches.h"
#include "motion/math/percentile.h"

namespace mien::motion {

namespace {

constexpr double phase_window_seconds = 2.0;
constexpr double farthest_seconds = 0.6;  // a limb half a second late is still found
constexpr double smallest_way = 0.02;     // m; of what hardly moves the phase means nothing
constexpr double least_correlation = 0.6;
constexpr double least_gain = 0.05;  // in correlation, over no shift at all

struct Window {
  int first;
  int last;  // included
};

std::vector<Window> windows(const LintSubject& subject) {
  const int whole = subject.frame_count();
  const int length =
      std::min(whole, static_cast<int>(std::lround(phase_window_seconds * subject.rate())));
  const int hop = std::max(1, length / 2);
  if (subject.was_loop) return {{subject.start, subject.start + subject.frames - 1}};
  std::vector<Window> result;
  int first = 0;
  for (; first + length < whole; first += hop) result.push_back({first, first + length - 1});
  result.push_back({whole - length, whole - 1});
  return result;
}

/// Correlation of what `way` does in the window with what `model` did `shift` frames earlier, over
/// the frames that both have; empty when they are too few or hardly move.
std::optional<double> correlation(const std::vector<Vec3>& way, const std::vector<Vec3>& model,
                                  const Window& window, int shift) {
  const int first = std::max(window.first, shift);
  const int last = std::min(window.last, static_cast<int>(model.size()) - 1 + shift);
  const int count = last - first + 1;
  if (2 * count < window.last - window.first + 1 || count < 4) return std::nullopt;
  Vec3 mean = Vec3::Zero();
  Vec3 model_mean = Vec3::Zero();
  for (int t = first; t <= last; ++t) {
    mean += way[t] / count;
    model_mean += model[t - shift] / count;
  }
  double both = 0.0;
  double own = 0.0;
  double of_model = 0.0;
  for (int t = first; t <= last; ++t) {
    const Vec3 a = way[t] - mean;
    const Vec3 b = model[t - shift] - model_mean;
    both += a.dot(b);
    own += a.squaredNorm();
    of_model += b.squaredNorm();
  }
  const double least = count * smallest_way * smallest_way;
  if (own < least || of_model < least) return std::nullopt;
  return both / std::sqrt(own * of_model);
}

/// The shift in frames, later being positive, at which the limb is most like its model.
struct Likeness {
  int shift = 0;
  double correlation = 0.0;
};

/// Empty where the limb or its model hardly moves.
std::optional<Likeness> likeness(const std::vector<Vec3>& way, const std::vector<Vec3>& model,
                                 const Window& window, double rate) {
  const auto unshifted = correlation(way, model, window, 0);
  if (!unshifted) return std::nullopt;
  const int farthest = static_cast<int>(std::lround(farthest_seconds * rate));
  Likeness best = {0, *unshifted};
  // Outward from no shift at all, so that the nearest of equal shifts of a periodic motion wins.
  for (int distance = 1; distance <= farthest; ++distance) {
    for (const int shift : {distance, -distance}) {
      const auto value = correlation(way, model, window, shift);
      const double needed = best.correlation + (best.shift == 0 ? least_gain : 1e-6);
      if (value && *value > needed) best = {shift, *value};
    }
  }
  return best;
}

/// What most limbs share is no fault of one: the whole motion may be timed anew.
double common_shift(const std::vector<std::optional<Likeness>>& limbs) {
  std::vector<double> shifts;
  for (const auto& limb : limbs) {
    if (limb && limb->correlation > least_correlation) shifts.push_back(limb->shift);
  }
  return shifts.size() < 3 ? 0.0 : percentile(shifts, 50);
}

/// Values a frame of one limb: 0 where nothing is wrong.
struct LimbFaults {
  std::vector<double> shift;       ///< seconds
  std::vector<double> unlikeness;  ///< 1 − correlation
};

void take_greater(std::vector<double>& values, const Window& window, double value) {
  for (int t = window.first; t <= window.last; ++t) values[t] = std::max(values[t], value);
}

std::vector<LimbFaults> limb_faults(const LintSubject& subject, const LintSubject& original) {
  std::vector<std::vector<Vec3>> ways;
  std::vector<std::vector<Vec3>> models;
  for (const int joint : limb_ends) {
    ways.push_back(limb_way(subject, joint));
    models.push_back(at_moments_of(subject, original, limb_way(original, joint)));
  }
  const double seconds = pace(subject, original) / subject.rate();  // of the original, a frame
  const std::vector<double> none(subject.world.size(), 0.0);
  std::vector<LimbFaults> faults(limb_ends.size(), {none, none});
  for (const Window& window : windows(subject)) {
    std::vector<std::optional<Likeness>> limbs;
    for (size_t i = 0; i < limb_ends.size(); ++i) {
      limbs.push_back(likeness(ways[i], models[i], window, subject.rate()));
    }
    const double common = common_shift(limbs);
    for (size_t i = 0; i < limb_ends.size(); ++i) {
      if (!limbs[i]) continue;
      take_greater(faults[i].unlikeness, window, 1.0 - limbs[i]->correlation);
      if (limbs[i]->correlation < least_correlation) continue;
      const double shift = std::abs(limbs[i]->shift - common) * seconds;
      take_greater(faults[i].shift, window, shift);
    }
  }
  return faults;
}

}  // namespace

Findings find_shifted_limbs(const LintSubject& subject, const LintOptions& options,
                            const LintSubject& original) {
  const std::vector<LimbFaults> faults = limb_faults(subject, original);
  Findings findings;
  for (size_t i = 0; i < limb_ends.size(); ++i) {
    const std::string name(name_of(BodyJoint(limb_ends[i])));
    const auto shifted = [&](double worst) {
      return "The " + spoken(name) + " moves " + rounded(worst, 2) +
             " s earlier or later than in the original, against the other limbs.";
    };
    const auto unlike = [&](double worst) {
      return "The " + spoken(name) + " no longer moves as in the original: correlation " +
             rounded(1.0 - worst, 2) + " at best.";
    };
    add_stretches(findings, subject,
                  {"limb-phase", name, "s", options.phase_shift_seconds, 0, 1, shifted},
                  faults[i].shift);
    add_stretches(findings, subject, {"limb-phase", name, "", options.unlikeness, 0, 1, unlike},
                  faults[i].unlikeness);
  }
  return findings;
}

}  // namespace mien::motion
