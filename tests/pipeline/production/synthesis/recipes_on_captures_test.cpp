#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait/contact.h"
#include "motion/gestures/hand_hits.h"
#include "motion/lint/lint.h"
#include "motion/modify/feet_apart.h"
#include "motion/modify/hit_timing.h"
#include "motion/modify/limb_timing.h"
#include "motion/modify/modification.h"
#include "motion/modify/real_takes.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/production/synthesis/modified_motion.h"

namespace mien::pipeline {
namespace {

using motion::Clip;

/// Of each joint the largest second difference of its place, metres.
std::vector<double> second_differences(const Clip& clip) {
  const auto paths = motion::joint_paths(clip);
  std::vector<double> largest(motion::body_joint_count, 0.0);
  for (std::size_t f = 2; f < paths.size(); ++f) {
    for (std::size_t j = 0; j < largest.size(); ++j) {
      const motion::Vec3 change = paths[f][j] - 2.0 * paths[f - 1][j] + paths[f - 2][j];
      largest[j] = std::max(largest[j], change.norm());
    }
  }
  return largest;
}

/// Three times what the original has and 15 mm.
double allowed(double of_original) { return 3.0 * of_original + 0.015; }

/// When a modification shows what of a limb, and how it hurries there.
struct LimbTiming {
  motion::BodyJoint end;
  std::vector<double> source;  ///< s(t), frames of the take, for every frame of the take
};

/// Of the hands of a take that hit something, and hit it harder.
std::vector<LimbTiming> timings_of_hits(const Clip& take, const motion::Modification& m) {
  std::vector<LimbTiming> found;
  for (const motion::Limb hand : {motion::Limb::left_hand, motion::Limb::right_hand}) {
    std::vector<motion::HandHit> hits = motion::hand_hits(take);
    std::erase_if(hits, [&](const motion::HandHit& hit) {
      return hit.left != (hand == motion::Limb::left_hand);
    });
    if (hits.empty() || !motion::has(m.limbs, hand)) continue;
    found.push_back(
        {motion::end_of(hand),
         motion::hard_hit_sources(hits, take.frame_count(), take.frames_per_second, take.loops)});
  }
  return found;
}

/// Of a take whose limbs speed up and slow down more at contacts or hits; none otherwise.
std::vector<LimbTiming> timings(const Clip& take, const motion::Modification& m) {
  std::vector<LimbTiming> found;
  if (m.acceleration <= 0.0) return found;
  if (m.acceleration_place == motion::AccelerationPlace::hits) return timings_of_hits(take, m);
  const double rate = take.frames_per_second;
  const std::vector<int> moments =
      motion::contact_frames(motion::foot_plants(take), take.frame_count());
  for (const motion::Limb limb : motion::all_limbs) {
    if (!motion::has(m.limbs, limb)) continue;
    std::vector<double> durations =
        motion::accelerated_durations(motion::limb_speeds(take, limb), rate, take.loops);
    if (m.acceleration_place == motion::AccelerationPlace::contacts)
      durations = motion::near_only(durations, moments, rate, take.loops);
    found.push_back(
        {motion::end_of(limb),
         motion::source_frames(durations, motion::acceleration_segment_seconds, rate, take.loops)});
  }
  return found;
}

/// The largest first and second differences of a joint's place within 0.1 s of a moment, m/s and
/// m/s².
struct Motion {
  double speed = 0.0;
  double acceleration = 0.0;
};

Motion motion_near(const std::vector<motion::JointTransforms>& world, std::size_t joint,
                   double frame, double rate) {
  Motion near;
  const int reach = static_cast<int>(std::ceil(0.1 * rate));
  const int middle = static_cast<int>(std::lround(frame));
  const int last = static_cast<int>(world.size()) - 2;
  for (int f = std::max(1, middle - reach); f <= std::min(last, middle + reach); ++f) {
    const auto place = [&](int at) { return world[static_cast<std::size_t>(at)].positions[joint]; };
    const motion::Vec3 step = place(f + 1) - place(f);
    const motion::Vec3 change = step - (place(f) - place(f - 1));
    near.speed = std::max(near.speed, rate * step.norm());
    near.acceleration = std::max(near.acceleration, rate * rate * change.norm());
  }
  return near;
}

/// What the recipe asks of the end of a limb: shown at s(t) it has, by the chain rule, the
/// acceleration s'² · x''(s) + s'' · x'(s), of which it gets the share that the recipe says, and
/// the rest as it was; as much longer as its paths, and by the square of the tempo. The largest
/// over the take, m/s².
double asked_acceleration(const Clip& take, const motion::Modification& m,
                          const LimbTiming& timing) {
  std::vector<motion::JointTransforms> world;
  for (const motion::Pose& pose : take.poses)
    world.push_back(motion::world_transforms(take.body, pose));
  const double rate = take.frames_per_second;
  const auto joint = static_cast<std::size_t>(timing.end);
  double largest = 0.0;
  for (std::size_t t = 1; t + 1 < timing.source.size(); ++t) {
    const std::vector<double>& s = timing.source;
    const double speed = std::max(s[t + 1] - s[t], s[t] - s[t - 1]);
    const double change = rate * std::abs(s[t + 1] - 2.0 * s[t] + s[t - 1]);
    const Motion plain = motion_near(world, joint, static_cast<double>(t), rate);
    const Motion shown = motion_near(world, joint, s[t], rate);
    largest = std::max(
        largest, (1.0 - m.acceleration) * plain.acceleration +
                     m.acceleration * (speed * speed * shown.acceleration + change * shown.speed));
  }
  return std::max(1.0, m.paths) * m.tempo.factor * m.tempo.factor * largest;
}

/// No joint leaps farther than `allowed`, or than the recipe asks of it where it hurries limbs.
void expect_no_leap(const Clip& before, const Clip& after, const std::string& what,
                    const Clip& take, const motion::Modification& m) {
  const std::vector<double> was = second_differences(before);
  const std::vector<double> is = second_differences(after);
  const double limit = allowed(*std::max_element(was.begin(), was.end()));
  std::vector<double> limits(is.size(), limit);
  const double rate = after.frames_per_second;
  for (const LimbTiming& timing : timings(take, m)) {
    double& of_end = limits[static_cast<std::size_t>(timing.end)];
    of_end = std::max(of_end, asked_acceleration(take, m, timing) / (rate * rate) + 0.015);
  }
  for (std::size_t j = 0; j < is.size(); ++j) {
    EXPECT_LT(is[j], limits[j]) << what << ": " << before.body.joints[j].name;
  }
}

/// Knees are held to what knees did.
void expect_no_leap_of_knees(const Clip& before, const Clip& after, const std::string& what) {
  const std::vector<double> was = second_differences(before);
  const std::vector<double> is = second_differences(after);
  const double limit = allowed(std::max(was[motion::LeftKnee], was[motion::RightKnee]));
  EXPECT_LT(is[motion::LeftKnee], limit) << what;
  EXPECT_LT(is[motion::RightKnee], limit) << what;
}

/// Feet are put down a foot's width apart, or as near as in the original, or as the recipe brings
/// them without turning thighs inwards.
void expect_feet_apart(const Clip& before, const Clip& after, const motion::Modification& m,
                       const std::string& what) {
  const auto plants = motion::foot_plants(before);
  if (m.tempo != 1.0 || !motion::may_bring_feet_together(m)) return;
  const auto was = motion::least_step_width(before, plants);
  const auto is = motion::least_step_width(after, plants);
  const auto without = motion::least_step_width(
      motion::modified(before, motion::with_feet_together(m, 0.0)), plants);
  if (!was || !is || !without) return;
  EXPECT_GE(*is, std::min({*was, *without, motion::foot_width(before.body)}) - 1e-6) << what;
}

void hold_recipes_to(const std::vector<Clip>& takes, bool at_30_too) {
  for (const Clip& take : takes) {
    for (const Recipe& recipe : read_recipes("builtin", "").recipes) {
      const std::string what = take.name + " " + recipe.name;
      const motion::Modification m = with_edit({}, recipe.edit);
      const Clip after = motion::modified(take, m);
      expect_no_leap(take, after, what, take, m);
      expect_no_leap_of_knees(take, after, what);
      expect_feet_apart(take, after, m, what);
      if (!at_30_too || take.frames_per_second <= 30.0) continue;
      expect_no_leap(motion::resampled(take, 30.0), motion::resampled(after, 30.0),
                     what + " at 30 frames per second", take, m);
    }
  }
}

/// Knees of these bow sideways and get nearly straight.
TEST(RecipesOnCaptures, ThrowNoJointOfWalksThatAreHard) {
  const std::vector<Clip> takes =
      test::real_takes("aalto-two-actors", "t_walk_regular_000_000_100");
  if (takes.empty()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  hold_recipes_to(takes, false);
  hold_recipes_to(test::real_takes("aalto-two-actors", "t_run_fast_t_run_slow_100_000"), false);
}

TEST(RecipesOnCaptures, ThrowNoJointOfAny) {
  if (!test::real_data()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  for (const char* folder : {"aalto-two-actors", "bandai-namco-1", "cmu"}) {
    hold_recipes_to(test::real_takes(folder, ""), true);
  }
}

/// Its toes bend far as it rolls off: a recipe that bends them otherwise must not push them through
/// the floor.
TEST(RecipesOnCaptures, SinkNoFootThatRollsOffOverItsToes) {
  if (!test::real_data()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  const Clip take =
      test::real_takes("aalto-two-actors", "k_run_slow_k_limp_fast_k_walk_regular_000_000_100")
          .at(0);
  const RecipeBook book = read_recipes("builtin", "");
  for (const char* emotion : {"relaxed", "afraid"}) {
    const Clip after = motion::modified(take, with_edit({}, book.find(emotion)->edit));
    for (const motion::Finding& finding : motion::lint(after, {}, &take)) {
      EXPECT_FALSE(finding.check == "penetration" && finding.severity == motion::Severity::error)
          << emotion << ": " << finding.sentence;
    }
  }
}

/// What is delivered is what is judged, the repair of the feet with it: no error comes through that
/// the capture has not.
TEST(RecipesOnCaptures, ThatMayNotFailDeliverNoErrorOfTheirOwn) {
  if (!test::real_data()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  const auto is_among = [](const motion::Finding& one, const std::vector<motion::Finding>& all) {
    return std::ranges::any_of(all, [&](const motion::Finding& other) {
      return other.severity == motion::Severity::error && other.check == one.check &&
             other.joint == one.joint;
    });
  };
  const RecipeBook book = read_recipes("builtin", "");
  for (const auto& [part, emotion] :
       {std::pair{"t_limp_slow_t_walk_slow_000_100", "strong"},
        std::pair{"k_run_slow_k_limp_fast_k_walk_regular_000_000_100", "relaxed"}}) {
    motion::Example original;
    original.clip = test::real_takes("aalto-two-actors", part).at(0);
    original.keytimes = {0.0, original.clip.duration_seconds()};
    Stimulus stimulus;
    stimulus.id = emotion;
    stimulus.on_fault = OnFault::fail;
    stimulus.output.fps = original.clip.frames_per_second;
    ModificationStep step;
    step.edit = book.find(emotion)->edit;
    step.modification = with_edit({}, step.edit);
    stimulus.modify.push_back(step);
    ModifiedMotion made;
    try {
      made = modify_motion(original, stimulus, {});
    } catch (const Error&) {
      continue;  // nothing is delivered
    }
    const auto own = motion::lint(original.clip);
    for (const motion::Finding& finding : motion::lint(made.motion.clip, {}, &original.clip)) {
      if (finding.severity != motion::Severity::error) continue;
      EXPECT_TRUE(is_among(finding, own)) << part << ": " << finding.sentence;
    }
  }
}

}  // namespace
}  // namespace mien::pipeline
