#include <gtest/gtest.h>

#include "motion/examples/make_example.h"
#include "motion/formats/motion_file.h"
#include "motion/measures/distance/distance.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/retarget.h"
#include "motion/style_transfer/fourier_style.h"
#include "motion/style_transfer/lti_style.h"
#include "motion/style_transfer/motion_warp.h"

#include "real_data.h"
#include "walk_pair.h"

// The methods that learn posture, movement and timing, on captured walks.

namespace mien::motion {
namespace {

using namespace mien::test;

class RealStyles : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!real_data())
      GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    neutral = captured("normal");
    styled = captured(GetParam());
    styled.clip = retarget(styled.clip, neutral.clip.body);
  }

  static Example captured(const std::string& style) {
    return make_example(to_body(read_motion(*real_data() / "mocap" / "bandai-namco-1" /
                                            ("dataset-1_walk_" + style + "_001.bvh"))));
  }

  /// The clip with the neutral keytimes at the same shares.
  Example example_of(const Clip& clip) const {
    Example example{"result", clip, neutral.keytimes};
    for (double& keytime : example.keytimes) {
      keytime *= clip.duration_seconds() / neutral.clip.duration_seconds();
    }
    return example;
  }

  void expect_near(const Clip& clip) const {
    const double before = distance(styled, neutral).mean;
    EXPECT_LT(distance(styled, example_of(clip)).mean, 0.5 * before);
    EXPECT_LT(largest_pop(clip),
              1.2 * std::max(largest_pop(neutral.clip), largest_pop(styled.clip)));
  }

  Example neutral;
  Example styled;
};

TEST_P(RealStyles, AreReachedByFourierSeries) {
  expect_near(fourier_styled(neutral.clip, neutral.clip, styled.clip));
}

TEST_P(RealStyles, AreReachedByALinearSystem) {
  const LtiStyleModel model = fit_lti_style(neutral.clip, styled.clip);
  EXPECT_LT(model.error_radians, 0.05);
  expect_near(translated(neutral.clip, model));
}

TEST_P(RealStyles, AreReachedByMotionWarping) { expect_near(warped_towards(neutral, styled)); }

INSTANTIATE_TEST_SUITE_P(Some, RealStyles,
                         testing::Values("sad", "tired", "angry", "proud", "happy", "old"),
                         [](const auto& style) { return std::string(style.param); });

}  // namespace
}  // namespace mien::motion
