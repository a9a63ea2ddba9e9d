#include "pipeline/manifest/determinants.h"

#include <functional>
#include <set>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

Hash key_of(const Stimulus& stimulus) {
  KeyBuilder key;
  FileKeys files;
  add_motion(key, stimulus, files);
  return key.key();
}

TEST(Determinants, OfAMotionHoldEveryOptionOfInterpolation) {
  const std::function<void(Interpolation&)> changes[] = {
      [](Interpolation&) {},
      [](Interpolation& how) { how.weights.method = motion::InterpolationMethod::kriging; },
      [](Interpolation& how) { how.weights.nearest.neighbours = 4; },
      [](Interpolation& how) { how.weights.nearest.trials = 4; },
      [](Interpolation& how) { how.weights.nearest.seed = 4; },
      [](Interpolation& how) { how.weights.power = 4.0; },
      [](Interpolation& how) { how.weights.grid_cells = 4; },
      [](Interpolation& how) { how.weights.grid_source = motion::GridSource::nearest; },
      [](Interpolation& how) { how.weights.kriging.linear_drift = false; },
      [](Interpolation& how) { how.weights.kriging.nugget = 0.4; },
      [](Interpolation& how) { how.weights.pca.variance_share = 0.4; },
      [](Interpolation& how) { how.weights.click_step = 0.4; },
      [](Interpolation& how) { how.rotations = motion::RotationBlend::markley_mean; },
      [](Interpolation& how) { how.time_warp = motion::WarpShape::linear; },
      [](Interpolation& how) { how.foot_lock = false; },
  };
  std::set<Hash> keys;
  for (const auto& change : changes) {
    Stimulus stimulus;
    stimulus.id = "a";
    stimulus.adjectives = {{"quickness", 0.5}};
    change(stimulus.interpolation);
    keys.insert(key_of(stimulus));
  }
  EXPECT_EQ(keys.size(), std::size(changes));
}

}  // namespace
}  // namespace mien::pipeline
