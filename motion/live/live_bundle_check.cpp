#include "motion/live/live_bundle_check.h"

#include <algorithm>
#include <cmath>

#include "motion/measures/features/feature_parameter.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_examples = 1000;
constexpr double longest_metres = 1000.0;

bool is_between(double value, double least, double most) { return value >= least && value <= most; }

bool is_near(const Vec3& v) { return v.cwiseAbs().maxCoeff() <= longest_metres; }

bool is_sound(const Skeleton& body) {
  return is_well_formed(body) && is_body(body) &&
         std::all_of(body.joints.begin(), body.joints.end(), [](const Joint& joint) {
           return is_near(joint.offset) && (!joint.tip || is_near(*joint.tip));
         });
}

bool ascend(const std::vector<double>& times) {
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (!(times[k] > times[k - 1])) return false;
  }
  return true;
}

bool is_sound(const Example& example) {
  const Clip& clip = example.clip;
  if (!is_sound(clip.body) || !is_between(clip.frames_per_second, 1.0, 1000.0)) return false;
  if (clip.poses.size() < 2 || !is_near(clip.cycle_displacement)) return false;
  for (const Pose& pose : clip.poses) {
    if (pose.rotations.size() != clip.body.joints.size() || !is_near(pose.root_position)) {
      return false;
    }
  }
  const std::vector<double>& keytimes = example.keytimes;
  return keytimes.size() >= 2 && ascend(keytimes) && keytimes.front() == 0.0 &&
         std::abs(keytimes.back() - clip.duration_seconds()) < 1e-6;
}

bool is_sound(const ParameterTable& table, std::size_t examples) {
  return static_cast<std::size_t>(table.values.rows()) == table.names.size() &&
         (table.names.empty() || static_cast<std::size_t>(table.values.cols()) == examples) &&
         (table.values.size() == 0 || table.values.cwiseAbs().maxCoeff() <= 1e6);
}

bool is_sound(const InterpolationOptions& options) {
  const bool ways = is_between(options.nearest.neighbours, 0, 1000) &&
                    is_between(options.nearest.trials, 0, 10000) &&
                    is_between(options.nearest.least_distance, 0.0, 1.0) &&
                    is_between(options.power, 1e-6, 100.0) &&
                    is_between(options.grid_cells, 1, 64) &&
                    is_between(options.click_step, 1e-6, 100.0);
  return ways && is_between(options.kriging.nugget, 0.0, 1.0) &&
         is_between(options.pca.noise, 1e-9, 100.0) &&
         is_between(options.pca.variance_share, 1e-6, 1.0) &&
         is_between(options.pca.ridge, 0.0, 100.0) && is_between(options.pca.samples, 2, 1000);
}

bool is_sound(const Showing& showing) { return is_between(showing.cycles, 1, 1000); }

bool is_sound(const LiveTarget& target) {
  return is_sound(target.motion) && is_sound(target.showing) && target.shown_frames >= 0;
}

bool are_alike(const Example& a, const Example& b) {
  return a.keytimes.size() == b.keytimes.size() && a.clip.loops == b.clip.loops;
}

bool are_features(const std::vector<std::string>& names) {
  const std::vector<std::string> known = feature_parameter_names();
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  });
}

}  // namespace

bool is_usable(const LiveBundle& bundle) {
  const std::vector<Example>& examples = bundle.examples.examples;
  if (examples.empty() || examples.size() > most_examples) return false;
  const bool sound_examples =
      std::all_of(examples.begin(), examples.end(), [&](const Example& example) {
        return is_sound(example) && are_alike(example, examples.front());
      });
  const bool sound_targets = std::all_of(bundle.targets.begin(), bundle.targets.end(),
                                         [](const LiveTarget& target) { return is_sound(target); });
  return sound_examples && sound_targets && is_sound(bundle.adjectives, examples.size()) &&
         is_sound(bundle.features, examples.size()) && are_features(bundle.features.names) &&
         is_sound(bundle.how.weights) && is_between(bundle.frames_per_second, 1.0, 1000.0) &&
         is_sound(bundle.showing);
}

}  // namespace mien::motion
