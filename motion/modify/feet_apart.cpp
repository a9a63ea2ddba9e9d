#include "motion/modify/feet_apart.h"

#include <algorithm>
#include <numeric>

#include "motion/gait/foot_path.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double least_stride = 0.1;    // metres; a shorter one has no direction
constexpr double width_of_foot = 0.09;  // m at 1.75 m

/// A foot that stands, and when.
struct Step {
  FootPlant plant;
  Vec3 ankle = Vec3::Zero();  ///< its mean place
};

/// All plants by time; of a loop those of the next cycle too, so that each has its neighbours.
std::vector<Step> steps_of(const Clip& clip, std::span<const FootPlant> plants) {
  std::vector<Step> steps;
  for (const bool left : {true, false}) {
    const FootPath path = foot_path(clip, left);
    for (const FootPlant& plant : plants) {
      if (plant.left != left) continue;
      Step step{plant};
      for (int f = plant.first; f <= plant.last; ++f) step.ankle += path.ankle_at(f);
      step.ankle /= plant.last - plant.first + 1;
      steps.push_back(step);
      for (int lap = 1; clip.loops && lap <= 2; ++lap) {
        step.plant.first += clip.frame_count();
        step.plant.last += clip.frame_count();
        step.ankle += clip.cycle_displacement;
        steps.push_back(step);
      }
    }
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
    return a.plant.first + a.plant.last < b.plant.first + b.plant.last;
  });
  return steps;
}

/// Widths of the stances: means while both feet stand.
std::vector<double> stance_widths(const Clip& clip, const std::vector<Step>& steps) {
  std::vector<double> widths;
  for (const Step& a : steps) {
    for (const Step& b : steps) {
      if (!a.plant.left || b.plant.left) continue;
      const int first = std::max(a.plant.first, b.plant.first);
      const int last = std::min({a.plant.last, b.plant.last, clip.frame_count() - 1});
      if (first > last) continue;
      double width = 0.0;
      for (int f = first; f <= last; ++f) {
        const Quat& pelvis = clip.poses[static_cast<size_t>(f)].rotations[Pelvis];
        const Vec3 to_left = heading(pelvis * Vec3::UnitZ()) * Vec3::UnitX();
        width += (a.ankle - b.ankle).dot(to_left) / (last - first + 1);
      }
      widths.push_back(width);
    }
  }
  return widths;
}

/// Widths of all steps or, if there are none, of the stances.
std::vector<double> step_widths(const Clip& clip, std::span<const FootPlant> plants) {
  const std::vector<Step> steps = steps_of(clip, plants);
  std::vector<double> widths;
  for (size_t i = 1; i + 1 < steps.size(); ++i) {
    const Step &before = steps[i - 1], &here = steps[i], &after = steps[i + 1];
    if (before.plant.left == here.plant.left || after.plant.left == here.plant.left) continue;
    const Vec3 stride = horizontal(after.ankle - before.ankle);
    if (stride.norm() < least_stride) continue;
    const Vec3 to_left = Vec3::UnitY().cross(stride.normalized());
    const double offset = (here.ankle - before.ankle).dot(to_left);
    widths.push_back(here.plant.left ? offset : -offset);
  }
  return widths.empty() ? stance_widths(clip, steps) : widths;
}

bool turns_thighs_inwards(const PostureChange& change) {
  return change.unit == PostureUnit::hip_abduction && change.degrees < 0.0;
}

}  // namespace

std::optional<double> least_step_width(const Clip& clip, std::span<const FootPlant> plants) {
  const std::vector<double> widths = step_widths(clip, plants);
  if (widths.empty()) return std::nullopt;
  return *std::min_element(widths.begin(), widths.end());
}

std::optional<double> mean_step_width(const Clip& clip, std::span<const FootPlant> plants) {
  const std::vector<double> widths = step_widths(clip, plants);
  if (widths.empty()) return std::nullopt;
  return std::accumulate(widths.begin(), widths.end(), 0.0) / static_cast<double>(widths.size());
}

double foot_width(const Skeleton& body) { return width_of_foot * relative_stature(body); }

bool may_bring_feet_together(const Modification& m) {
  return m.pose_difference || std::any_of(m.posture.begin(), m.posture.end(), turns_thighs_inwards);
}

Modification with_feet_together(const Modification& modification, double share) {
  Modification m = modification;
  for (PostureChange& change : m.posture) {
    if (turns_thighs_inwards(change)) change.degrees *= share;
  }
  if (!m.pose_difference) return m;
  for (const BodyJoint hip : {LeftHip, RightHip}) {
    Quat& turn = m.pose_difference->turns[hip];
    turn = exp(share * log(turn));
  }
  return m;
}

}  // namespace mien::motion
