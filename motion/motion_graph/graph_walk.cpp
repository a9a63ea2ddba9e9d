#include "motion/motion_graph/graph_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "motion/error.h"
#include "motion/gait/foot_lock.h"
#include "motion/interpolation/blend.h"
#include "motion/steered_walk/root_motion.h"

namespace mien::motion {

namespace {

double facing(const Quat& rotation) {
  const Vec3 forward = rotation * Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z());
}

/// Versions of a graph that are mixed, and how, frame by frame of a walk.
struct Mix {
  std::span<const MotionGraph> versions;
  std::vector<WalkFrame> frames;
  std::vector<std::vector<double>> shares;  ///< of the versions, a frame; sum 1
  std::vector<double> times;                ///< at which each frame begins, seconds
};

/// The frames of a walk with the shares that follow the moods.
Mix mixed(std::span<const MotionGraph> versions, const GraphWalk& walk,
          std::span<const MoodChange> moods) {
  constexpr double mood_stiffness = 12.0;  // 1/s
  Mix mix{versions, frames_of(versions.front(), walk), {}, {}};
  std::vector<DampedSpring> followers;
  for (const double share : requested_shares(moods, 0.0, versions.size())) {
    followers.push_back({share, 0.0});
  }
  double now = 0.0;
  for (const WalkFrame& frame : mix.frames) {
    const std::vector<double> asked = requested_shares(moods, now, versions.size());
    std::vector<double> shares;
    double lasts = 0.0;
    for (std::size_t v = 0; v < versions.size(); ++v) {
      shares.push_back(followers[v].value);
      lasts += followers[v].value * seconds_of(versions[v], frame);
    }
    for (std::size_t v = 0; v < versions.size(); ++v) {
      followers[v] = spring_step(followers[v], asked[v], mood_stiffness, lasts);
    }
    mix.shares.push_back(std::move(shares));
    mix.times.push_back(now);
    now += lasts;
  }
  return mix;
}

Pose posture_of(const Mix& mix, std::size_t f, double turn) {
  Pose pose = posture_of(mix.versions.front(), mix.frames[f], turn);
  if (mix.versions.size() == 1) return pose;
  std::vector<Pose> poses;
  std::vector<double> shares;
  pose.root_position.setZero();
  for (std::size_t v = 0; v < mix.versions.size(); ++v) {
    const double share = std::max(0.0, mix.shares[f][v]);
    if (share < 1e-9) continue;
    poses.push_back(posture_of(mix.versions[v], mix.frames[f], turn));
    shares.push_back(share);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share /= sum;
  for (std::size_t p = 0; p < poses.size(); ++p) {
    pose.root_position += shares[p] * poses[p].root_position;
  }
  std::vector<Quat> rotations(poses.size());
  for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
    for (std::size_t p = 0; p < poses.size(); ++p) rotations[p] = poses[p].rotations[j];
    pose.rotations[j] = blend_rotations(rotations, shares, RotationBlend::karcher_mean);
  }
  return pose;
}

Vec3 step_of(const Mix& mix, std::size_t f, double turn) {
  Vec3 step = Vec3::Zero();
  for (std::size_t v = 0; v < mix.versions.size(); ++v) {
    step += mix.shares[f][v] * step_of(mix.versions[v], mix.frames[f], turn);
  }
  return step;
}

Clip untimed_clip(const Mix& mix, const GraphWalkOptions& options) {
  const MotionGraph& graph = mix.versions.front();
  const std::vector<WalkFrame>& frames = mix.frames;
  Clip clip;
  clip.body = graph.clips.front().body;
  clip.frames_per_second = graph.clips.front().frames_per_second;
  const Pose& first = graph.clips[static_cast<std::size_t>(frames.front().clip)]
                          .poses[static_cast<std::size_t>(frames.front().frame)];
  double turn = options.heading - facing(first.rotations.front());
  Vec3 place = horizontal(options.place);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    // After a transition the clip that was entered is the one that is played.
    const bool arrived =
        f > 0 && frames[f - 1].to_clip >= 0 &&
        (frames[f].clip != frames[f - 1].clip || frames[f].frame != frames[f - 1].frame + 1);
    if (arrived) turn += frames[f - 1].turn;
    const double added = options.added_headings.empty() ? 0.0 : options.added_headings[f];
    if (f > 0) place += step_of(mix, f, turn + added);
    Pose pose = posture_of(mix, f, turn + added);
    pose.root_position += place;
    clip.poses.push_back(std::move(pose));
  }
  return clip;
}

/// The clip and its plants at an even frame rate, when its frames last as long as they should.
WalkedClip in_time(const Mix& mix, Clip clip, std::vector<FootPlant> plants) {
  const bool even = std::all_of(mix.versions.begin(), mix.versions.end(),
                                [](const MotionGraph& g) { return g.frame_seconds.empty(); });
  const std::vector<double>& times = mix.times;
  if (even || times.size() == 1) return {std::move(clip), std::move(plants)};
  const auto frame_at = [&](int f) {
    return times[static_cast<std::size_t>(f)] * clip.frames_per_second;
  };
  for (FootPlant& plant : plants) {
    plant.first = static_cast<int>(std::ceil(frame_at(plant.first) - 1e-9));
    plant.last = static_cast<int>(std::floor(frame_at(plant.last) + 1e-9));
  }
  std::erase_if(plants, [](const FootPlant& plant) { return plant.last < plant.first; });
  std::vector<Pose> poses;
  std::size_t i = 0;
  for (int f = 0; f / clip.frames_per_second <= times.back() + 1e-9; ++f) {
    const double seconds = std::min(f / clip.frames_per_second, times.back());
    while (i + 2 < times.size() && times[i + 1] < seconds) ++i;
    const double t = std::clamp((seconds - times[i]) / (times[i + 1] - times[i]), 0.0, 1.0);
    poses.push_back(interpolate(clip.poses[i], clip.poses[i + 1], t));
  }
  clip.poses = std::move(poses);
  return {std::move(clip), std::move(plants)};
}

void check_versions(std::span<const MotionGraph> versions, std::span<const MoodChange> moods) {
  bool alike = !versions.empty();
  for (const MotionGraph& version : versions) {
    alike = alike && version.edges.size() == versions.front().edges.size() &&
            version.clips.size() == versions.front().clips.size();
    for (std::size_t c = 0; alike && c < version.clips.size(); ++c) {
      alike = version.clips[c].frame_count() == versions.front().clips[c].frame_count();
    }
  }
  if (!alike) {
    throw Error("versions of different motion graphs cannot be mixed",
                "derive them from one graph (with_motions)");
  }
  for (const MoodChange& from : moods) {
    double sum = 0.0;
    for (const double weight : from.moods) {
      if (!(weight >= 0.0)) sum = std::numeric_limits<double>::quiet_NaN();
      sum += weight;
    }
    if (!(sum > 0.0) || !std::isfinite(sum) || from.moods.size() > versions.size()) {
      throw Error("invalid weights of a motion graph's versions",
                  "give each version a weight of at least 0, not all 0");
    }
  }
}

/// The plants that overlap a transition.
std::vector<FootPlant> at_transitions(const std::vector<FootPlant>& plants,
                                      const std::vector<WalkFrame>& frames) {
  std::vector<FootPlant> touching;
  for (const FootPlant& plant : plants) {
    const auto first = frames.begin() + plant.first;
    if (std::any_of(first, frames.begin() + plant.last + 1,
                    [](const WalkFrame& frame) { return frame.to_clip >= 0; })) {
      touching.push_back(plant);
    }
  }
  return touching;
}

/// Locked until the feet stand: once is not always enough where the legs hardly reach.
Clip with_locked_feet(Clip clip, const std::vector<FootPlant>& plants) {
  constexpr double still_m = 0.002;
  constexpr int most_locks = 6;
  FootLockOptions lock;
  lock.keep_velocity = true;
  lock.extension = 0.995;
  for (int i = 0; i < most_locks && planted_drift(clip, plants) > still_m; ++i) {
    clip = foot_locked(clip, plants, lock);
  }
  return clip;
}

}  // namespace

Clip motion_of(const MotionGraph& graph, const GraphWalk& walk, const GraphWalkOptions& options) {
  return motion_of(std::span(&graph, 1), walk, {}, options);
}

Clip motion_of(std::span<const MotionGraph> versions, const GraphWalk& walk,
               std::span<const MoodChange> moods, const GraphWalkOptions& options) {
  return walked_clip(versions, walk, moods, options).clip;
}

WalkedClip walked_clip(std::span<const MotionGraph> versions, const GraphWalk& walk,
                       std::span<const MoodChange> moods, const GraphWalkOptions& options) {
  check_versions(versions, moods);
  if (walk.edges.empty()) throw Error("a walk over a motion graph has no frames", "add an edge");
  const Mix mix = mixed(versions, walk, moods);
  if (!options.added_headings.empty() && options.added_headings.size() != mix.frames.size()) {
    throw Error(
        "headings are added to a walk over a motion graph with a different number of frames",
        "give one per frame of the walk");
  }
  Clip clip = untimed_clip(mix, options);
  std::vector<FootPlant> plants = plants_of(versions.front(), mix.frames);
  if (options.lock_feet) {
    const bool all = versions.size() > 1 || !options.added_headings.empty();
    clip = with_locked_feet(clip, all ? plants : at_transitions(plants, mix.frames));
  }
  return in_time(mix, std::move(clip), std::move(plants));
}

WalkHeadings headings_of(std::span<const MotionGraph> versions, const GraphWalk& walk,
                         std::span<const MoodChange> moods, const GraphWalkOptions& options) {
  check_versions(versions, moods);
  const Mix mix = mixed(versions, walk, moods);
  WalkHeadings headings{mix.times, {}};
  for (const Pose& pose : untimed_clip(mix, options).poses) {
    headings.facings.push_back(facing(pose.rotations.front()));
  }
  return headings;
}

}  // namespace mien::motion
