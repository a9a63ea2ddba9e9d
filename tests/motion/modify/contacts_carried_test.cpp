#include "motion/modify/contacts_carried.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/examples/settled_feet.h"
#include "motion/lint/lint.h"
#include "motion/math/rotation.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/style_transfer/fourier_style.h"
#include "motion/style_transfer/lti_style.h"
#include "motion/style_transfer/style_components.h"
#include "motion/style_transfer/style_timing.h"

namespace mien::motion {
namespace {

const std::vector<Example>& walks() {
  static const std::vector<Example> settled =
      with_settled_feet(builtin_examples("walks-10")).examples;
  return settled;
}

const Example& any_walk(std::mt19937_64& random) {
  return walks()[std::uniform_int_distribution<size_t>(0, walks().size() - 1)(random)];
}

TEST(ContactsCarried, LeaveAMotionWithStillFeetWhereItIs) {
  for (const Example& walk : walks()) {
    const TimedOriginal original =
        timed_original(walk.clip, even_source_frames(walk.clip, walk.clip.frame_count()));
    const Clip carried = with_contacts_carried(original.still, original);
    // Feet are locked until the ball lifts; then they may slide by some millimetres.
    EXPECT_LT(contact_slide(original.still, original), 0.01) << walk.name;
    EXPECT_LT(contact_slide(carried, original), 1e-3) << walk.name;
    for (size_t f = 0; f < carried.poses.size(); ++f) {
      const auto now = world_positions(carried.body, carried.poses[f]);
      const auto before = world_positions(original.still.body, original.still.poses[f]);
      for (int j = 0; j < body_joint_count; ++j) {
        EXPECT_LT((now[j] - before[j]).norm(), 0.02) << walk.name << " " << f << " " << j;
      }
    }
  }
}

TEST(ContactsCarried, MeasureAFootThatIsDragged) {
  const Clip& walk = walks().front().clip;
  const TimedOriginal original = timed_original(walk, even_source_frames(walk, walk.frame_count()));
  Clip dragged = original.still;
  for (int f = 0; f < dragged.frame_count(); ++f) {
    dragged.poses[f].root_position.x() += 0.01 * f;  // sideways by a centimetre a frame
  }
  dragged.cycle_displacement.x() += 0.01 * dragged.frame_count();
  const FootPlant& plant = original.plants.front();
  EXPECT_NEAR(contact_slide(dragged, original), 0.01 * (plant.last - plant.first), 0.04);
  EXPECT_LT(contact_slide(with_contacts_carried(dragged, original), original), 1e-3);
}

/// Planted feet after a method, at any strength, of any motion in any style. At moderate strengths,
/// lint, which looks for contacts by itself, agrees.
void expect_planted(const Clip& styled, const Clip& motion, const std::vector<double>& source,
                    double strength, const std::string& what) {
  const TimedOriginal original = timed_original(motion, source);
  ASSERT_FALSE(original.plants.empty()) << what;
  const Clip planted = with_contacts_carried(styled, original);
  EXPECT_LT(contact_slide(planted, original), 0.01) << what;
  EXPECT_LT(contact_height_error(planted, original), 0.01) << what;
  if (strength > 1.0) return;
  for (const Finding& finding : lint(planted, {}, &motion)) {
    EXPECT_NE(finding.check, "foot-skate") << what << ": " << finding.sentence;
  }
}

TEST(ContactsCarried, PlantTheFeetOfRandomStyles) {
  std::mt19937_64 random(39);
  std::uniform_real_distribution<double> strengths(0.0, 3.0);
  for (int trial = 0; trial < 40; ++trial) {
    const Example& motion = any_walk(random);
    const Example& neutral = any_walk(random);
    const Example& style = any_walk(random);
    const double strength = strengths(random);
    const std::string what =
        motion.name + ": " + neutral.name + " to " + style.name + " × " + std::to_string(strength);
    const Clip by_series =
        fourier_styled(motion.clip, neutral.clip, style.clip, {.amount = strength});
    const auto keytimes =
        styled_keytimes(motion, neutral, style, strength, by_series.duration_seconds());
    expect_planted(by_series, motion.clip,
                   corresponding_frames(motion, keytimes, by_series.frame_count()), strength,
                   what + " by Fourier series");
    const LtiTranslation by_system =
        translation(motion.clip, fit_lti_style(neutral.clip, style.clip), {.amount = strength});
    expect_planted(by_system.clip, motion.clip, by_system.source_frames, strength,
                   what + " by a system");
    const StyleComponentOptions options{.amount = strength};
    const Clip by_components =
        restyled(motion.clip, style_components(neutral.clip, style.clip, options), options);
    expect_planted(by_components, motion.clip,
                   even_source_frames(motion.clip, by_components.frame_count()), strength,
                   what + " by components");
  }
}

}  // namespace
}  // namespace mien::motion
