#include <array>
#include <tuple>

#include <gtest/gtest.h>

#include "injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// A leg from a given pelvis to an ankle place, the foot turned by `pitch` about X, in place.
void put_leg(Pose& pose, const Skeleton& body, bool left, const Vec3& ankle, double pitch) {
  const auto side = [left](BodyJoint joint) { return left ? joint : mirrored(joint); };
  const JointTransforms world = world_transforms(body, pose);
  const TwoBoneLimb limb = {world.positions[side(LeftHip)], world.positions[side(LeftKnee)],
                            world.positions[side(LeftAnkle)]};
  const TwoBoneSolution solution = solve_two_bone(limb, ankle, Vec3::UnitZ());
  const Quat thigh = solution.upper_turn * world.rotations[side(LeftHip)];
  const Quat shank = solution.lower_turn * world.rotations[side(LeftKnee)];
  pose.rotations[side(LeftHip)] = pose.rotations[Pelvis].conjugate() * thigh;
  pose.rotations[side(LeftKnee)] = thigh.conjugate() * shank;
  pose.rotations[side(LeftAnkle)] = shank.conjugate() * exp(Vec3(pitch, 0, 0));
}

/// Running as springs run: the centre flies on a parabola for `flight` seconds and sinks along half
/// a sine for `stance` seconds, alternately on either foot.
struct Run {
  double speed = 4.0;
  double stance = 0.2;
  double flight = 0.12;
  double rate = 30.0;

  double step() const { return stance + flight; }
};

/// Height above the take-off height, `seconds` after a foot came down.
double bounce(const Run& run, double seconds) {
  const double fall = 0.5 * 9.81 * run.flight;  // speed at touch-down
  if (seconds < run.stance) return -fall * run.stance / pi * std::sin(pi * seconds / run.stance);
  const double flown = seconds - run.stance;
  return fall * flown - 0.5 * 9.81 * flown * flown;
}

/// The ankle of a foot that stands at `stand` (its place along Z) from −stance/2 to stance/2 around
/// its middle time, and swings to the next stand, high behind and before the body.
struct Foot {
  Vec3 ankle;
  double pitch;
};

Foot running_foot(const Run& run, double seconds, bool left) {
  const double x = left ? 0.06 : -0.06;
  const double stride = 2.0 * run.step();
  const double own = seconds - (left ? 0.0 : run.step());
  const double lap = std::floor(own / stride);
  const double since = own - lap * stride;
  const double stand = run.speed * (lap * stride + (left ? 0.0 : run.step()) + 0.5 * run.stance);
  if (since <= run.stance) return {Vec3(x, 0.08, stand), 0.0};
  const double swing = (since - run.stance) / (stride - run.stance);
  const double smooth = swing * swing * (3.0 - 2.0 * swing);
  const double lift = std::sin(pi * swing);
  const double high = 0.45 * lift * lift * (1.2 - 0.8 * swing);
  return {Vec3(x, 0.08 + high, stand + smooth * run.speed * stride), 0.7 * lift * (1.0 - swing)};
}

Clip running(const Run& run, double seconds = 3.0) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = run.rate;
  for (int t = 0; t < seconds * run.rate; ++t) {
    const double time = t / run.rate;
    const double since = std::fmod(time, run.step());
    const double cycle = pi * time / run.step();
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.root_position = Vec3(0, 0.89 + bounce(run, since), run.speed * time);
    pose.rotations[Pelvis] = exp(Vec3(0.1, 0, 0));
    for (const bool left : {true, false}) {
      const Foot foot = running_foot(run, time, left);
      put_leg(pose, clip.body, left, foot.ankle, foot.pitch);
      const double swing =
          (left ? -0.5 : 0.5) * std::cos(cycle - 0.5 * pi * run.stance / run.step());
      const double sign = left ? 1.0 : -1.0;
      pose.rotations[left ? LeftShoulder : RightShoulder] =
          exp(Vec3(swing, 0, 0)) * exp(Vec3(0, 0, -1.4 * sign));
      pose.rotations[left ? LeftElbow : RightElbow] = exp(Vec3(0, -1.4 * sign, 0));
    }
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(MovesOfPeople, RunsNeitherHangNorSkate) {
  for (const double rate : {30.0, 60.0, 120.0}) {
    for (const auto& [speed, stance, flight] :
         {std::tuple(2.5, 0.26, 0.08), {3.5, 0.22, 0.12}, {5.0, 0.16, 0.14}, {7.0, 0.12, 0.13}}) {
      const Clip clip = running({speed, stance, flight, rate});
      const std::vector<Finding> findings = lint(clip);
      for (const char* check : {"floating", "foot-skate", "balance"}) {
        EXPECT_FALSE(find_error(findings, check)) << speed << " m/s at " << rate << " Hz\n"
                                                  << all_of(findings);
      }
    }
  }
}

TEST(MovesOfPeople, RunsThatSlideAreErrors) {
  for (const double rate : {30.0, 120.0}) {
    Clip clip = running({3.5, 0.22, 0.12, rate});
    for (int t = 0; t < clip.frame_count(); ++t) clip.poses[t].root_position.x() += 0.8 * t / rate;
    EXPECT_TRUE(find_error(lint(clip), "foot-skate")) << all_of(lint(clip));
  }
}

TEST(MovesOfPeople, RunsThatHangInTheAirAreErrors) {
  Clip clip = running({});
  for (Pose& pose : clip.poses) pose.root_position.y() += 0.08;
  EXPECT_TRUE(find_error(lint(clip), "floating")) << all_of(lint(clip));
}

TEST(MovesOfPeople, KneelingHasNoErrors) {
  // The shanks lie on the floor behind the knees, the soles look up.
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 30.0;
  const double thigh = clip.body.joints[LeftKnee].offset.norm();
  for (int t = 0; t < 90; ++t) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    const double nod = 0.03 * std::sin(2 * pi * 0.5 * t / 30.0);
    pose.root_position = Vec3(0, thigh + 0.1 - clip.body.joints[LeftHip].offset.y(), 0);
    pose.rotations[Spine] = exp(Vec3(nod, 0, 0));
    for (const bool left : {true, false}) {
      pose.rotations[left ? LeftKnee : RightKnee] = exp(Vec3(0.5 * pi, 0, 0));
      pose.rotations[left ? LeftAnkle : RightAnkle] = exp(Vec3(0.75, 0, 0));
      pose.rotations[left ? LeftShoulder : RightShoulder] = exp(Vec3(0, 0, left ? -1.4 : 1.4));
    }
    clip.poses.push_back(pose);
  }
  const auto findings = lint(clip);
  EXPECT_FALSE(has_errors(findings)) << all_of(findings);
  for (const char* check : {"floating", "balance", "foot-skate", "forces"}) {
    EXPECT_FALSE(find(findings, check)) << all_of(findings);
  }
}

TEST(MovesOfPeople, FlungLimbsOfSlowRecordingsAreNoJumps) {
  // An elbow that strikes out once, within a tenth of a second: steps of 20°, 60° and 26°.
  Clip clip = three_cycles(builtin_walks()[0]);
  const std::array<double, 7> degrees = {0, 5, 25, 85, 111, 117, 120};
  for (int t = 0; t < clip.frame_count(); ++t) {
    const auto at = static_cast<size_t>(std::clamp(t - 30, 0, 6));
    clip.poses[t].rotations[LeftElbow] = exp(Vec3(0, -degrees[at] * radians_per_degree, 0));
  }
  EXPECT_FALSE(find_error(lint(clip), "jump", "LeftElbow")) << all_of(lint(clip));
}

TEST(MovesOfPeople, FeetInTheAirDoNotSkate) {
  // On one leg; the other foot is held up and drawn slowly through the air.
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 60.0;
  for (int t = 0; t < 240; ++t) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.root_position = Vec3(0, 0.96, 0);
    const double turn = 0.9 + 0.2 * std::sin(2 * pi * 0.25 * t / 60.0);
    pose.rotations[RightHip] = exp(Vec3(-turn, 0, 0));
    pose.rotations[RightKnee] = exp(Vec3(1.2, 0, 0));
    pose.rotations[RightAnkle] = exp(Vec3(turn - 1.2, 0, 0));
    clip.poses.push_back(pose);
  }
  EXPECT_FALSE(find(lint(clip), "foot-skate")) << all_of(lint(clip));
}

}  // namespace
}  // namespace mien::motion
