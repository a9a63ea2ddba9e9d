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

// A film in neutral colours does not show the role: it is not rendered again for it.
TEST(Determinants, OfAFilmHoldTheRoleWhereItsColourShows) {
  const auto key_of = [](Colours colours, Role role) {
    Stimulus stimulus;
    stimulus.id = "a";
    stimulus.role = role;
    stimulus.look.colours = colours;
    KeyBuilder key;
    FileKeys files;
    add_film(key, stimulus, files);
    return key.key();
  };
  EXPECT_NE(key_of(Colours::role, Role::target), key_of(Colours::role, Role::reference));
  EXPECT_EQ(key_of(Colours::neutral, Role::target), key_of(Colours::neutral, Role::reference));
}

TEST(Determinants, OfPagesHoldTheLanguageOfNames) {
  const auto key_of = [](NameLanguage names, const char* language) {
    Manifest manifest;
    manifest.names = names;
    if (language != nullptr) {
      manifest.matching.emplace();
      manifest.matching->language = {{language}, false};
    }
    KeyBuilder key;
    add_page(key, manifest);
    return key.key();
  };
  const Hash as_study = key_of(NameLanguage::study, nullptr);
  EXPECT_NE(key_of(NameLanguage::both, nullptr), as_study);
  EXPECT_NE(key_of(NameLanguage::japanese, nullptr), as_study);
  EXPECT_NE(key_of(NameLanguage::study, "ja"), key_of(NameLanguage::study, "de"));
  EXPECT_EQ(key_of(NameLanguage::study, "ja"), key_of(NameLanguage::study, "ja"));
}

}  // namespace
}  // namespace mien::pipeline
