#include "motion/dynamics/limb_dynamics.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/body_mass.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/math/rotation.h"
#include "motion/measures/distance/distance.h"
#include "motion/measures/features/motion_features.h"
#include "motion/modify/modification.h"
#include "motion/modify/path_measures.h"
#include "motion/procedural/walker.h"
#include "motion/refusal.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Stiffness arms(double stiffness) {
  Stiffness result;
  result.left_arm = result.right_arm = stiffness;
  return result;
}

/// A body that stands with straight arms, turned in the shoulder by `angle(f)` about the crosswise
/// axis from hanging (0) forwards.
template <class Angle>
Clip straight_arms(int frames, double rate, bool loops, const Angle& angle) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = rate;
  clip.loops = loops;
  for (int f = 0; f < frames; ++f) {
    Pose pose = standing_pose(clip.body);
    for (const bool left : {true, false}) {
      const double side = left ? 1.0 : -1.0;
      pose.rotations[left ? LeftShoulder : RightShoulder] =
          about(Vec3::UnitX(), -angle(f)) * about(Vec3::UnitZ(), -0.5 * pi * side);
      pose.rotations[left ? LeftElbow : RightElbow] = Quat::Identity();
    }
    clip.poses.push_back(pose);
  }
  return clip;
}

/// Angle of an upper arm from hanging along the chest, forwards, radians.
double arm_angle(const Clip& clip, int frame) {
  const JointTransforms world = world_transforms(clip.body, clip.poses[static_cast<size_t>(frame)]);
  const Vec3 bone = world.rotations[Chest].conjugate() *
                    (world.positions[LeftElbow] - world.positions[LeftShoulder]);
  return std::atan2(bone.z(), -bone.y());
}

/// g·(distance of the centre of mass)/(inertia per mass) of a straight arm about its shoulder,
/// 1/s²: the square of its frequency as a pendulum for small angles.
double pendulum(const Clip& clip) {
  const JointTransforms world = world_transforms(clip.body, clip.poses.front());
  const std::vector<SegmentMass> segments = segment_masses(clip.body, world);
  double mass = 0.0, inertia = 0.0;
  Vec3 centre = Vec3::Zero();
  constexpr double radii[] = {0.08, 0.07, 0.04};
  for (int i = 0; i < 3; ++i) {
    const SegmentMass& part = segments[static_cast<size_t>(2 + i)];
    const Vec3 lever = part.centre - world.positions[LeftShoulder];
    mass += part.share;
    centre += part.share * lever;
    inertia += part.share * (lever.squaredNorm() + radii[i] * radii[i]);
  }
  return gravity * centre.norm() / inertia;
}

TEST(LimbDynamics, OfOrdinaryStiffnessChangeNothing) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  EXPECT_EQ(largest_distance(with_limb_dynamics(clip, {}, 1.0), clip), 0.0);
}

TEST(LimbDynamics, GiveTheMotionBackAsStiffnessGrows) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  double last = INFINITY;
  for (const double k : {0.5, 0.8, 0.95, 0.99, 0.999}) {
    const Clip other = with_limb_dynamics(clip, {k, k, k, k, 1.0}, 1.0);
    const double distance = largest_distance(other, clip);
    EXPECT_LT(distance, 0.6 * last) << k;
    last = distance;
  }
  EXPECT_LT(last, 1e-3);
}

TEST(LimbDynamics, SagToTheStaticEquilibrium) {
  for (const double raised : {0.5, 1.2, 0.5 * pi, 2.2}) {
    const Clip clip = straight_arms(20, 30.0, false, [&](int) { return raised; });
    const double square = pendulum(clip);
    for (const double k : {0.35, 0.5, 0.7}) {
      for (const double weight : {1.0}) {
        const double w = muscle_spring(k, arm_hz).frequency;
        // ω²·(raised − angle)·… balances (1 − k)·square·sin(angle), by bisection.
        double least = 0.0, most = raised;
        for (int i = 0; i < 60; ++i) {
          const double angle = 0.5 * (least + most);
          const double yielding = 1.0 - std::pow((raised - angle) / 1.6, 2);
          const double pull = yielding * (1.0 - k) * weight * square * std::sin(angle);
          (w * w * (raised - angle) > pull ? least : most) = angle;
        }
        const Clip sagged = with_limb_dynamics(clip, arms(k), weight);
        EXPECT_NEAR(arm_angle(sagged, 0), least, 0.004) << raised << " at " << k;
        EXPECT_NEAR(arm_angle(sagged, 19), least, 0.004) << "it stays there";
      }
    }
  }
}

TEST(LimbDynamics, LagAsADrivenPendulumDoes) {
  // Small swings about hanging: θ'' = −ω²(θ − target) − 2ζωθ' − (1 − k)·g·l/J·θ.
  for (const double hertz : {0.4, 0.9, 1.6}) {
    const int frames = static_cast<int>(std::lround(120.0 / hertz));
    constexpr double amplitude = 0.05;
    const Clip clip = straight_arms(
        frames, 120.0, true, [&](int f) { return amplitude * std::cos(2.0 * pi * f / frames); });
    const double s = 2.0 * pi * 120.0 / frames;
    for (const double k : {0.15, 0.3, 0.5}) {
      const SpringDamper spring = muscle_spring(k, arm_hz);
      const double w = spring.frequency;
      const std::complex<double> response =
          w * w /
          (w * w + (1.0 - k) * pendulum(clip) - s * s +
           std::complex<double>(0.0, 2.0 * spring.damping * w * s));
      const Clip swung = with_limb_dynamics(clip, arms(k), 1.0);
      std::complex<double> found = 0.0;
      for (int f = 0; f < frames; ++f)
        found += 2.0 / frames * arm_angle(swung, f) / amplitude *
                 std::polar(1.0, -2.0 * pi * f / frames);
      EXPECT_NEAR(std::abs(found), std::abs(response), 0.03 * std::abs(response) + 0.01)
          << hertz << " Hz at " << k;
      EXPECT_NEAR(std::remainder(std::arg(found) - std::arg(response), 2.0 * pi), 0.0, 0.06)
          << hertz << " Hz at " << k;
    }
  }
}

TEST(LimbDynamics, SwingOnWhenSlackAndDoNotOvershootWhenStiff) {
  const auto lifted = [](int f) { return f < 60 ? 0.1 : f < 66 ? 0.1 + 0.15 * (f - 60) : 1.0; };
  const Clip clip = straight_arms(400, 60.0, false, lifted);
  const auto overshoot = [&](double k) {
    const Clip other = with_limb_dynamics(clip, arms(k), 1.0);
    double highest = 0.0;
    for (int f = 0; f < 400; ++f) highest = std::max(highest, arm_angle(other, f));
    return highest - arm_angle(other, 399);
  };
  EXPECT_GT(overshoot(0.3), 0.05);
  EXPECT_GT(overshoot(0.3), overshoot(0.6));
  EXPECT_LT(overshoot(0.95), 0.002);
  EXPECT_LT(overshoot(1.0), 1e-9);
  EXPECT_LT(overshoot(1.5), 0.06);
}

TEST(LimbDynamics, AreTheSameAtEveryFrameRate) {
  const Stiffness slack{0.4, 0.4, 0.25, 0.25, 1.0};
  std::vector<std::vector<std::vector<Vec3>>> places;
  for (const double rate : {30.0, 60.0, 120.0}) {
    WalkStyle style;
    style.cadence_steps_min = 120.0;  // a cycle of exactly a second
    places.push_back(
        joint_paths(with_limb_dynamics(walk(style, rate, standard_body()).clip, slack, 1.0)));
  }
  ASSERT_EQ(places[0].size(), 30U);
  ASSERT_EQ(places[2].size(), 120U);
  for (size_t f = 0; f < 30; ++f) {
    for (size_t j = 0; j < body_joint_count; ++j) {
      EXPECT_LT((places[0][f][j] - places[2][4 * f][j]).norm(), 0.008) << f << ' ' << j;
      EXPECT_LT((places[1][2 * f][j] - places[2][4 * f][j]).norm(), 0.003) << f << ' ' << j;
    }
  }
}

TEST(LimbDynamics, CloseInLoopsWhereTheOpenMotionSettles) {
  const Clip loop = walk({}, 60.0, standard_body()).clip;
  for (const double k : {0.15, 0.3, 0.6}) {
    const Stiffness slack{0.4, 0.4, k, k, 1.0};
    const Clip closed = with_limb_dynamics(loop, slack, 1.0);
    const Clip open = with_limb_dynamics(repeated(loop, 25), slack, 1.0);
    const auto once = joint_paths(closed), often = joint_paths(open);
    const size_t count = once.size();
    double largest = 0.0;
    for (size_t f = 0; f < count; ++f) {
      for (size_t j = 0; j < body_joint_count; ++j) {
        const Vec3 a = once[f][j] - once[f][Pelvis];
        const Vec3 b = often[22 * count + f][j] - often[22 * count + f][Pelvis];
        largest = std::max(largest, (a - b).norm());
      }
    }
    EXPECT_LT(largest, 0.002) << k;
    EXPECT_LT(largest_second_difference(closed), 2.0 * largest_second_difference(loop)) << k;
  }
}

TEST(LimbDynamics, GiveWayToMoreWeight) {
  const Clip clip = straight_arms(20, 30.0, false, [](int) { return 1.2; });
  const double own = arm_angle(clip, 0);
  double last = INFINITY;
  for (const double weight : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0}) {
    const double angle = arm_angle(with_limb_dynamics(clip, {}, weight), 0);
    EXPECT_LT(angle, last) << weight;
    if (weight == 1.0) {
      EXPECT_EQ(angle, own);
    }
    last = angle;
  }
  // Additional weight against ordinary muscles.
  const double expected = 0.2 * pendulum(clip) * std::sin(1.2) / std::pow(2.0 * pi * arm_hz, 2);
  EXPECT_NEAR(own - arm_angle(with_limb_dynamics(clip, {}, 1.2), 0), expected, 0.002);
}

TEST(LimbDynamics, HoldTheShareOfTheMovementThatStiffnessSays) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  const double own = path_length(clip, LeftWrist);
  double last = own;
  for (const double k : {1.25, 1.5, 1.75, 2.0}) {
    const double length = path_length(with_limb_dynamics(clip, arms(k), 1.0), LeftWrist);
    EXPECT_LT(length, last);
    last = length;
  }
  // What is left moves with the trunk.
  EXPECT_LT(last, 0.35 * own);
}

TEST(LimbDynamics, NeverBendElbowsBackwards) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  for (const double k : {0.0, 0.1, 0.3}) {
    const Clip slack = with_limb_dynamics(clip, arms(k), 2.0);
    for (const Pose& pose : slack.poses) {
      const Vec3 bone = pose.rotations[LeftElbow] * Vec3::UnitX();
      const Vec3 hinge = -Vec3::UnitY();
      EXPECT_GT(std::atan2(Vec3::UnitX().cross(bone).dot(hinge), bone.x()), -0.1) << k;
    }
  }
}

TEST(LimbDynamics, StayFiniteForAnyStiffnessAndWeight) {
  const Clip clip = repeated(walk({}, 30.0, standard_body()).clip, 2);
  for (const double k : {0.0, 0.01, 0.1, 0.2, 0.9999, 2.0}) {
    for (const double weight : {0.0, 1.0, 3.0}) {
      const Clip other = with_limb_dynamics(clip, {k, k, k, k, 1.0}, weight);
      for (const Pose& pose : other.poses)
        for (const Quat& rotation : pose.rotations) EXPECT_TRUE(rotation.coeffs().allFinite());
    }
  }
}

TEST(LimbDynamics, SinkOnSlackLegsByWhatTheirSpringYields) {
  Clip clip = straight_arms(60, 60.0, false, [](int) { return 0.0; });
  for (Pose& pose : clip.poses) {
    pose.root_position.y() -= 0.03;
    for (const BodyJoint hip : {LeftHip, RightHip}) {
      const auto places = world_positions(clip.body, standing_pose(clip.body));
      put_leg(pose, clip.body, hip, {places[static_cast<size_t>(hip + 2)], 0.0});
    }
  }
  const std::vector<FootPlant> plants = {{true, 0, 59}, {false, 0, 59}};
  const double own = body_heights(clip).front();
  for (const double k : {0.4, 0.5, 0.8}) {
    const double w = muscle_spring(k, leg_hz).frequency;
    const Clip sunk = with_slack_legs(clip, k, 1.0, plants, {});
    EXPECT_NEAR(own - body_heights(sunk)[30], (1.0 - k) * gravity / (w * w), 3e-4) << k;
    const auto before = joint_paths(clip), after = joint_paths(sunk);
    EXPECT_LT((before[30][LeftAnkle] - after[30][LeftAnkle]).norm(), 1e-6);
  }
}

TEST(LimbDynamics, LeaveFeetPlantedAndLoopsClosed) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  Modification m;
  m.stiffness = {0.4, 0.4, 0.2, 0.2, 0.4};
  m.weight = 1.2;
  const ModifiedClip slack = modify(clip, m);
  EXPECT_LT(planted_drift(slack.clip, foot_plants(clip)), 0.01);
  EXPECT_LT(largest_second_difference(slack.clip), 2.0 * largest_second_difference(clip));
  EXPECT_EQ(largest_distance(slack.clip, modify(clip, m).clip), 0.0);
  EXPECT_GT(largest_distance(slack.clip, clip), 0.05);
}

/// A walk with a change, with its keytimes.
Example changed_walk(const Example& neutral, const Modification& m) {
  Example result = neutral;
  result.clip = modified(neutral.clip, m);
  const double longer = result.clip.duration_seconds() / neutral.clip.duration_seconds();
  for (double& keytime : result.keytimes) keytime *= longer;
  return result;
}

TEST(LimbDynamics, TellStiffSlackAndSlowWalksApart) {
  const Example neutral = walk({}, 30.0, standard_body());
  Modification stiff;
  stiff.tempo = 1.15;
  stiff.paths = 0.6;
  stiff.stiffness = {1.7, 1.6, 1.8, 1.8, 1.0};
  stiff.posture = {{PostureUnit::shoulder_elevation, 8.0},
                   {PostureUnit::elbow_flexion, 20.0},
                   {PostureUnit::shoulder_flexion, 8.0},
                   {PostureUnit::hip_flexion, 6.0},
                   {PostureUnit::knee_flexion, 6.0}};
  Modification slack;
  slack.paths = 1.2;
  slack.stiffness = {0.45, 0.4, 0.5, 0.5, 0.5};
  slack.weight = 1.3;
  Modification slow;
  slow.tempo = 0.7;
  slow.gravity = TempoGravity::kept;
  slow.stiffness = {0.6, 0.6, 0.12, 0.12, 1.0};
  std::vector<Example> walks;
  std::vector<FeatureValues> features;
  for (const Modification& m : {stiff, slack, slow}) {
    walks.push_back(changed_walk(neutral, m));
    features.push_back(measure_features(walks.back()));
  }
  const FeatureValues own = measure_features(neutral);
  for (size_t a = 0; a < 3; ++a) {
    for (size_t b = a + 1; b < 3; ++b) {
      EXPECT_GE(distance(walks[a], walks[b]).mean, 0.05) << a << ' ' << b;
      int opposite = 0;
      for (size_t f = 0; f < own.size(); ++f) {
        // A fifth of what counts as a change of a captured motion.
        const FeatureUnit unit = motion_features()[f].unit;
        const double least = unit == FeatureUnit::degrees             ? 0.2
                             : unit == FeatureUnit::metres            ? 0.002
                             : unit == FeatureUnit::metres_per_second ? 0.01
                                                                      : 0.006;
        const double first = features[a][f] - own[f], second = features[b][f] - own[f];
        if (first * second < 0.0 && std::min(std::abs(first), std::abs(second)) > least) ++opposite;
      }
      EXPECT_GE(opposite, 10) << a << ' ' << b;
    }
  }
}

TEST(LimbDynamics, ScaleWithStrengthAndRefuseNonsense) {
  Modification m;
  m.stiffness = {0.5, 1.6, 0.2, 1.0, 0.4};
  m.weight = 1.4;
  EXPECT_TRUE(is_identity(scaled(m, 0.0)));
  const Modification half = scaled(m, 0.5);
  EXPECT_DOUBLE_EQ(half.stiffness.head, 0.75);
  EXPECT_DOUBLE_EQ(half.stiffness.trunk, 1.3);
  EXPECT_DOUBLE_EQ(half.weight, 1.2);
  EXPECT_DOUBLE_EQ(scaled(m, 2.0).stiffness.head, 0.0);
  EXPECT_DOUBLE_EQ(scaled(m, 2.0).stiffness.trunk, 2.0);
  m.stiffness.legs = 1.2;
  EXPECT_EQ(refusal_of([&] { check(m); }),
            "stiffness of the legs is 1.2; give a number from 0 to 1");
  m.stiffness = {};
  m.stiffness.head = std::nan("");
  EXPECT_EQ(refusal_of([&] { check(m); }),
            "stiffness of the head is nan; give a number from 0 to 2");
  m.stiffness = {};
  m.weight = -1.0;
  EXPECT_EQ(refusal_of([&] { check(m); }), "weight is -1; give a number from 0 to 3");
}

}  // namespace
}  // namespace mien::motion
