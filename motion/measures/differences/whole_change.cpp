#include "motion/measures/differences/whole_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "motion/math/rotation.h"
#include "motion/measures/distance/similarity.h"

namespace mien::motion {

namespace {

constexpr double left_of_a_move = 0.01;
constexpr double left_of_a_mirror = 0.15;
constexpr double least_apart_m = 0.01;
constexpr double least_turned = 1.0 * radians_per_degree;

/// Places of joints that stand opposite to one another, and on the midline; all frames in a row.
struct SidedPaths {
  std::vector<Vec3> before;
  std::vector<Vec3> opposite;  ///< before, of the joint on the other side
  std::vector<Vec3> now;
};

SidedPaths sided_paths(const PairedMotions& pair) {
  SidedPaths paths;
  for (int t = 0; t < pair.frames; ++t) {
    for (const SharedJoint& shared : pair.joints) {
      if (shared.opposite < 0) continue;
      const auto& before = pair.before.world[t].positions;
      paths.before.push_back(before[shared.before]);
      paths.opposite.push_back(before[pair.joints[shared.opposite].before]);
      paths.now.push_back(pair.now.world[t].positions[shared.now]);
    }
  }
  return paths;
}

bool has_sides(const PairedMotions& pair) {
  for (std::size_t j = 0; j < pair.joints.size(); ++j) {
    const int opposite = pair.joints[j].opposite;
    if (opposite >= 0 && opposite != static_cast<int>(j)) return true;
  }
  return false;
}

double rms_apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return a.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(a.size()));
}

WholeBodyChange after_level_fit(WholeChange kind, const std::vector<Vec3>& from,
                                const std::vector<Vec3>& to, bool mirrored) {
  const HorizontalTransform fit = horizontal_fit(from, to, mirrored);
  std::vector<Vec3> there;
  for (const Vec3& point : from) there.push_back(fit(point));
  return {.kind = kind,
          .turn_radians = fit.turn_radians,
          .shift = fit.shift,
          .before = rms_apart(from, to),
          .remaining = rms_apart(there, to)};
}

/// RMS angle between the turns of all joints on their parents and those of others.
double rms_turned(const PairedMotions& pair, const Skeleton& before, const Skeleton& now,
                  bool swapped) {
  double sum = 0.0;
  int count = 0;
  for (int t = 0; t < pair.frames; ++t) {
    for (std::size_t j = 0; j < pair.joints.size(); ++j) {
      if (pair.joints[j].opposite < 0) continue;
      const int from = swapped ? pair.joints[j].opposite : static_cast<int>(j);
      const double angle = angle_between(local_before(pair, before, from, t).rotation,
                                         local_now(pair, now, static_cast<int>(j), t).rotation);
      sum += angle * angle;
      ++count;
    }
  }
  return count == 0 ? 0.0 : std::sqrt(sum / count);
}

std::optional<WholeBodyChange> swapped_turns(const PairedMotions& pair, const Skeleton& before,
                                             const Skeleton& now) {
  WholeBodyChange change;
  change.kind = WholeChange::swapped_turns;
  change.before = rms_turned(pair, before, now, false);
  if (change.before < least_turned) return std::nullopt;
  change.remaining = rms_turned(pair, before, now, true);
  if (change.remaining > left_of_a_mirror * change.before) return std::nullopt;
  return change;
}

/// By least squares about the origin; a figure that is a little larger is no other unit.
std::optional<WholeBodyChange> scaled(const std::vector<Vec3>& before,
                                      const std::vector<Vec3>& now) {
  constexpr double least_factor = 1.5;
  double common = 0.0, size = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    common += before[i].dot(now[i]);
    size += before[i].squaredNorm();
  }
  if (!(common > 0.0) || !(size > 0.0)) return std::nullopt;
  WholeBodyChange change;
  change.kind = WholeChange::scaled;
  change.scale = common / size;
  std::vector<Vec3> there;
  for (const Vec3& point : before) there.push_back(change.scale * point);
  change.before = rms_apart(before, now);
  change.remaining = rms_apart(there, now);
  const bool is_other_unit = std::abs(std::log(change.scale)) > std::log(least_factor);
  // In the smaller of both units: of a figure that shrank, little is left whatever else it does.
  const double most_left = left_of_a_move * std::min(1.0, change.scale) * change.before;
  return is_other_unit && change.remaining <= most_left ? std::optional(change) : std::nullopt;
}

/// Or scaled.
std::optional<WholeBodyChange> moved(const PairedMotions& pair) {
  std::vector<Vec3> before, now;
  for (int t = 0; t < pair.frames; ++t) {
    for (const SharedJoint& shared : pair.joints) {
      before.push_back(pair.before.world[t].positions[shared.before]);
      now.push_back(pair.now.world[t].positions[shared.now]);
    }
  }
  if (before == now || before.size() < 2) return std::nullopt;
  if (const auto change = scaled(before, now)) return change;
  const WholeBodyChange change = after_level_fit(WholeChange::moved, before, now, false);
  const bool explains = change.before > 1e-6 && change.remaining <= left_of_a_move * change.before;
  return explains ? std::optional(change) : std::nullopt;
}

}  // namespace

std::string_view name_of(WholeChange change) {
  static constexpr std::array<std::string_view, 7> names = {
      "none", "moved", "mirrored", "flipped", "renamed-sides", "swapped-turns", "scaled"};
  return names[static_cast<std::size_t>(change)];
}

WholeBodyChange whole_change(const PairedMotions& pair, const Skeleton& before,
                             const Skeleton& now) {
  if (const auto change = moved(pair)) return *change;
  if (!has_sides(pair)) return {};
  const SidedPaths paths = sided_paths(pair);
  const double apart =
      after_level_fit(WholeChange::moved, paths.before, paths.now, false).remaining;
  WholeBodyChange best;
  double least = left_of_a_mirror;
  const auto consider = [&](const WholeBodyChange& change, double without) {
    if (change.remaining >= least * without) return;
    least = change.remaining / without;
    best = change;
    best.before = without;
  };
  if (apart >= least_apart_m) {
    consider(after_level_fit(WholeChange::mirrored, paths.opposite, paths.now, true), apart);
    consider(after_level_fit(WholeChange::flipped, paths.before, paths.now, true), apart);
    consider(after_level_fit(WholeChange::renamed_sides, paths.opposite, paths.now, false), apart);
  }
  if (const auto change = swapped_turns(pair, before, now)) consider(*change, change->before);
  return best;
}

RootDifference root_difference(const PairedMotions& pair, const Skeleton& before) {
  RootDifference root;
  const auto children = children_of(before);
  for (std::size_t j = 0; j < pair.joints.size(); ++j) {
    if (children[pair.joints[j].before].size() < 2) continue;
    root.joint = static_cast<int>(j);
    break;
  }
  const SharedJoint& shared = pair.joints[root.joint];
  for (int t = 0; t < pair.frames; ++t) {
    const JointTransforms& was = pair.before.world[t];
    const JointTransforms& is = pair.now.world[t];
    const Vec3 way = is.positions[shared.now] - was.positions[shared.before];
    root.path_m.push_back(horizontal(way).norm());
    root.height_m.push_back(std::abs(way.y()));
    const Quat& from = was.rotations[shared.before];
    const Quat& to = is.rotations[shared.now];
    const Quat turn = from.coeffs() == to.coeffs() ? Quat::Identity()
                                                   : Quat((to * from.conjugate()).normalized());
    const Quat heading = twist_about(turn, Vec3::UnitY());
    root.heading_radians.push_back(log(heading).norm());
    root.tilt_radians.push_back(log(turn * heading.conjugate()).norm());
  }
  return root;
}

}  // namespace mien::motion
