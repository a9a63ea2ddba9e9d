#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "motion/biomechanics/lint_motion.h"
#include "motion/lint/checks.h"
#include "motion/lint/limb_ends.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/filter.h"
#include "motion/math/percentile.h"

namespace mien::motion {

namespace {

constexpr double farthest_seconds = 0.6;    // a limb half a second late is still found
constexpr double least_limb_travel = 0.02;  // m; of what hardly moves the phase means nothing
constexpr double least_correlation = 0.6;
constexpr double least_gain = 0.05;  // in correlation, over no shift at all
// Of a motion with itself: it falls below this and rises above `least_correlation` within a period.
constexpr double turned_correlation = 0.5;

/// Correlation of what `way` does in the window with what `model` did `shift` frames earlier, over
/// the frames that both have; empty when they are too few or hardly move.
std::optional<double> correlation(const std::vector<Vec3>& way, const std::vector<Vec3>& model,
                                  const FrameWindow& window, int shift) {
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
  const double least = count * least_limb_travel * least_limb_travel;
  if (own < least || of_model < least) return std::nullopt;
  return both / std::sqrt(own * of_model);
}

/// The shift in frames, later being positive, at which the limb is most like its model.
struct ShiftedCorrelation {
  int shift = 0;
  double correlation = 0.0;
};

/// The largest shift that can be told apart, frames: half a period of a model that repeats itself,
/// because a limb that is a whole period late moves as in the original.
int farthest_shift(const std::vector<Vec3>& model, const FrameWindow& window, double rate) {
  const int farthest = static_cast<int>(std::lround(farthest_seconds * rate));
  bool has_turned = false;
  double last = 1.0;
  for (int lag = 1; lag <= 2 * farthest; ++lag) {
    const auto value = correlation(model, model, window, lag);
    if (!value) break;
    if (has_turned && last > least_correlation && *value < last) return (lag - 1) / 2;
    has_turned = has_turned || *value < turned_correlation;
    last = *value;
  }
  return farthest;
}

/// Empty where the limb or its model hardly moves.
std::optional<ShiftedCorrelation> best_correlation(const std::vector<Vec3>& way,
                                                   const std::vector<Vec3>& model,
                                                   const FrameWindow& window, double rate) {
  const auto unshifted = correlation(way, model, window, 0);
  if (!unshifted) return std::nullopt;
  const int farthest = farthest_shift(model, window, rate);
  ShiftedCorrelation best = {0, *unshifted};
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
double common_shift(const std::vector<std::optional<ShiftedCorrelation>>& limbs) {
  std::vector<double> shifts;
  for (const auto& limb : limbs) {
    if (limb && limb->correlation > least_correlation) shifts.push_back(limb->shift);
  }
  return shifts.size() < 3 ? 0.0 : percentile(shifts, 50);
}

/// Values a frame of one limb: 0 where nothing is wrong.
struct LimbFaults {
  std::vector<double> shift;          ///< seconds
  std::vector<double> dissimilarity;  ///< 1 − correlation
};

std::vector<LimbFaults> limb_faults(const LintMotion& motion, const LintMotion& original) {
  std::vector<std::vector<Vec3>> ways;
  std::vector<std::vector<Vec3>> models;
  for (const int joint : limb_ends) {
    ways.push_back(limb_path(motion, joint));
    models.push_back(at_moments_of(motion, original, limb_path(original, joint)));
  }
  const double seconds = pace(motion, original) / motion.rate();  // of the original, a frame
  const std::vector<double> none(motion.world.size(), 0.0);
  std::vector<LimbFaults> faults(limb_ends.size(), {none, none});
  for (const FrameWindow& window : limb_windows(motion)) {
    std::vector<std::optional<ShiftedCorrelation>> limbs;
    for (size_t i = 0; i < limb_ends.size(); ++i) {
      limbs.push_back(best_correlation(ways[i], models[i], window, motion.rate()));
    }
    const double common = common_shift(limbs);
    for (size_t i = 0; i < limb_ends.size(); ++i) {
      if (!limbs[i]) continue;
      raise_to(faults[i].dissimilarity, window, 1.0 - limbs[i]->correlation);
      if (limbs[i]->correlation < least_correlation) continue;
      const double shift = std::abs(limbs[i]->shift - common) * seconds;
      raise_to(faults[i].shift, window, shift);
    }
  }
  return faults;
}

constexpr double jerk_window_seconds = 0.5;
constexpr double smooth_jerk = 10.0;  // m/s³; what is smoother is as good as still

/// Root mean square of the jerk around each frame, m/s³.
std::vector<double> jerks(const LintMotion& motion, int joint) {
  const double rate = motion.rate();
  std::vector<Vec3> way = low_pass(limb_path(motion, joint), std::min(10.0, 0.3 * rate), rate);
  for (int order = 0; order < 3; ++order) way = derivative(way, rate);
  const int count = static_cast<int>(way.size());
  const int reach = static_cast<int>(std::lround(0.5 * jerk_window_seconds * rate));
  std::vector<double> values;
  for (int t = 0; t < count; ++t) {
    const int first = std::max(0, t - reach);
    const int last = std::min(count - 1, t + reach);
    double sum = 0.0;
    for (int i = first; i <= last; ++i) sum += way[i].squaredNorm();
    values.push_back(std::sqrt(sum / (last - first + 1)));
  }
  return values;
}

}  // namespace

Findings find_shifted_limbs(const LintMotion& motion, const LintOptions& options,
                            const LintMotion& original) {
  const std::vector<LimbFaults> faults = limb_faults(motion, original);
  Findings findings;
  for (size_t i = 0; i < limb_ends.size(); ++i) {
    const std::string name(name_of(BodyJoint(limb_ends[i])));
    const auto shifted = [&](double worst) {
      return "The " + display_name(name) + " moves " + rounded(worst, 2) +
             " s earlier or later than in the original, against the other limbs.";
    };
    const auto unlike = [&](double worst) {
      return "The " + display_name(name) + " no longer moves as in the original: correlation " +
             rounded(1.0 - worst, 2) + " at best.";
    };
    add_threshold_findings(findings, motion,
                           {"limb-phase", name, "s", options.phase_shift_seconds, 0, 1, shifted},
                           faults[i].shift);
    add_threshold_findings(findings, motion,
                           {"limb-phase", name, "", options.dissimilarity, 0, 1, unlike},
                           faults[i].dissimilarity);
  }
  return findings;
}

Findings find_jerks(const LintMotion& motion, const LintOptions& options,
                    const LintMotion& original) {
  Findings findings;
  for (const int joint : limb_ends) {
    const double usual = std::max(percentile(jerks(original, joint), 90), smooth_jerk);
    std::vector<double> ratios = jerks(motion, joint);
    for (double& value : ratios) value /= usual;
    const std::string name(name_of(BodyJoint(joint)));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " moves " + rounded(worst, 1) +
             " times as jerkily as in the original.";
    };
    add_threshold_findings(findings, motion, {"jerk", name, "", options.jerk_ratio, 0, 2, sentence},
                           ratios);
  }
  return findings;
}

}  // namespace mien::motion
