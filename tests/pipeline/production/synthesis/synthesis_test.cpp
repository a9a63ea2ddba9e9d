#include "pipeline/production/synthesis/synthesis.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/examples/settled_feet.h"
#include "motion/formats/motion_file.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/interpolation/blend.h"
#include "motion/math/rotation.h"
#include "motion/measures/distance/distance.h"
#include "motion/skeleton/recorded_hands.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/temporary_folder.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

Manifest builtin_manifest() {
  Manifest manifest;
  manifest.study = "test";
  manifest.seed = 7;
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  return manifest;
}

Manifest real_manifest(const std::filesystem::path& data) {
  Manifest manifest;
  manifest.study = "real";
  manifest.examples.folder = data / "mocap" / "bandai-namco-1";
  manifest.examples.include = "*walk*.bvh";
  manifest.ratings.source = Ratings::Source::file;
  manifest.ratings.file = data / "mocap" / "bandai-namco-1" / "ratings.csv";
  manifest.scales =
      scales_in(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / "five-factors.scales.yaml");
  return manifest;
}

/// Adjectives that are exactly those of one example.
Stimulus like_example(const Repertoire& repertoire, int example,
                      const std::vector<std::string>& parameters) {
  Stimulus stimulus;
  stimulus.id = "like";
  for (const std::string& name : parameters) {
    stimulus.adjectives.emplace_back(
        name, repertoire.parameters.values(repertoire.parameters.find(name), example));
  }
  return stimulus;
}

double largest_difference(const motion::Clip& a, const motion::Clip& b) {
  EXPECT_EQ(a.frame_count(), b.frame_count());
  double largest = 0.0;
  for (size_t f = 0; f < std::min(a.poses.size(), b.poses.size()); ++f) {
    largest = std::max(largest, (a.poses[f].root_position - b.poses[f].root_position).norm());
    for (size_t j = 0; j < a.poses[f].rotations.size(); ++j) {
      largest = std::max(largest,
                         motion::angle_between(a.poses[f].rotations[j], b.poses[f].rotations[j]));
    }
  }
  return largest;
}

void expect_examples_at_their_own_parameters(const Repertoire& repertoire,
                                             const std::vector<std::string>& parameters) {
  for (int i = 0; i < static_cast<int>(repertoire.names.size()); ++i) {
    Stimulus stimulus = like_example(repertoire, i, parameters);
    stimulus.interpolation.foot_lock = false;
    const motion::Example& example = repertoire.examples.examples[static_cast<size_t>(i)];
    stimulus.output.fps = example.clip.frames_per_second;
    const Synthesis made = synthesize(stimulus, repertoire);
    EXPECT_LT(largest_difference(made.motion.clip, example.clip), 1e-9) << example.name;
  }
}

TEST(Synthesis, AtAnExamplesOwnParametersIsThatExample) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  ASSERT_EQ(repertoire.names.size(), 10u);
  expect_examples_at_their_own_parameters(repertoire,
                                          {"quickness", "clearness", "activeness", "largeness"});
  expect_examples_at_their_own_parameters(
      repertoire, {"quickness", "sad-happy", "small-large", "activeness", "largeness"});
}

TEST(Synthesis, OfBuiltInWalksSaysThatTheRatingsAreSimulated) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  EXPECT_TRUE(repertoire.simulated_ratings);
  EXPECT_TRUE(repertoire.parameters.simulated);
}

TEST(Synthesis, MoreQuicknessWalksFaster) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  const auto speed = [&](double quickness) {
    Stimulus stimulus;
    stimulus.adjectives = {{"quickness", quickness}};
    const motion::Clip clip = synthesize(stimulus, repertoire).motion.clip;
    return clip.cycle_displacement.z() / clip.duration_seconds();
  };
  EXPECT_GT(speed(0.8), speed(0.5) + 0.05);
  EXPECT_GT(speed(0.5), speed(0.2) + 0.05);
}

TEST(Synthesis, WeightsNeedNotSumToOne) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  Stimulus stimulus;
  stimulus.weights = {{"normal", 3.0}, {"proud", 1.0}};
  const Eigen::VectorXd weights = weights_of(stimulus, repertoire);
  EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
  EXPECT_NEAR(weights.maxCoeff(), 0.75, 1e-12);
}

constexpr motion::InterpolationMethod all_methods[] = {
    motion::InterpolationMethod::cardinal,         motion::InterpolationMethod::nearest,
    motion::InterpolationMethod::inverse_distance, motion::InterpolationMethod::grid,
    motion::InterpolationMethod::kriging,          motion::InterpolationMethod::pca,
    motion::InterpolationMethod::incremental};

TEST(Synthesis, GoesTheAskedWayByEveryMethod) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  for (const auto method : all_methods) {
    const auto made_with = [&](double quickness) {
      Stimulus stimulus;
      stimulus.adjectives = {{"quickness", quickness}, {"largeness", 0.5}};
      stimulus.interpolation.weights.method = method;
      return synthesize(stimulus, repertoire);
    };
    const Synthesis slow = made_with(0.25);
    const Synthesis fast = made_with(0.75);
    EXPECT_GT(fast.reached[0].second, slow.reached[0].second + 0.1) << name_of(method);
    EXPECT_LT(fast.motion.clip.duration_seconds(), slow.motion.clip.duration_seconds())
        << name_of(method);
    EXPECT_NEAR(fast.weights.sum(), 1.0, 1e-9) << name_of(method);
    EXPECT_LT(fast.planted_drift_m, 0.003) << name_of(method);
    EXPECT_EQ(fast.expected_error_m.has_value(), method == motion::InterpolationMethod::kriging);
  }
}

TEST(Synthesis, TellsTheClicksOfIncrementalInterpolation) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  Stimulus stimulus;
  stimulus.adjectives = {{"quickness", 0.8}};
  stimulus.interpolation.weights.method = motion::InterpolationMethod::incremental;
  const Synthesis made = synthesize(stimulus, repertoire);
  EXPECT_TRUE(std::any_of(made.warnings.begin(), made.warnings.end(), [](const std::string& told) {
    return told.starts_with("clicks: ") && told.find("× quickness up") != std::string::npos;
  }));
}

TEST(Synthesis, TellsWhenAdjectivesAreMoreThanTheExamplesCanTellApart) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  Stimulus stimulus;
  for (const std::string& name : repertoire.parameters.names) {
    if (stimulus.adjectives.size() < 12) stimulus.adjectives.emplace_back(name, 0.5);
  }
  const Synthesis made = synthesize(stimulus, repertoire);
  ASSERT_FALSE(made.warnings.empty());
  EXPECT_NE(made.warnings.front().find("more parameters than 10 different examples"),
            std::string::npos);
}

TEST(Synthesis, PlantedFeetStandStillInEveryBlend) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  for (double q : {0.1, 0.5, 0.9}) {
    for (double l : {0.2, 0.8}) {
      Stimulus stimulus;
      stimulus.adjectives = {{"quickness", q}, {"largeness", l}, {"sad-happy", 1.0 - q}};
      EXPECT_LT(synthesize(stimulus, repertoire).planted_drift_m, 0.002) << q << " " << l;
    }
  }
}

TEST(Synthesis, InPlaceTheClipStaysAndOtherwiseItTravels) {
  const Repertoire repertoire = load_repertoire(builtin_manifest());
  Stimulus stimulus;
  stimulus.weights = {{"normal", 1.0}};
  const Synthesis made = synthesize(stimulus, repertoire);
  Output output;
  output.cycles = 3;
  const motion::Clip travelling = playback_clip(made.motion.clip, output);
  EXPECT_EQ(travelling.frame_count(), 3 * made.motion.clip.frame_count());
  EXPECT_GT(travelling.poses.back().root_position.z(), 3.0);
  output.in_place = true;
  EXPECT_LT(std::abs(playback_clip(made.motion.clip, output).poses.back().root_position.z()), 0.3);
}

TEST(Motions, OfFilesAreComparedWithSettledFeetAsThoseOfBlends) {
  const test::TemporaryFolder folder;
  Manifest manifest = builtin_manifest();
  Stimulus blend;
  blend.id = "blend";
  blend.weights = {{"happy", 0.5}, {"sad", 0.5}};
  Stimulus free = blend;
  free.interpolation.foot_lock = false;
  const motion::Clip skating = synthesize(free, load_repertoire(manifest)).motion.clip;
  motion::write_motion(motion::to_recording(motion::repeated(skating, 2)),
                       folder.path() / "skating.bvh");
  Stimulus file;
  file.id = "file";
  file.clip = ClipSource{.file = folder.path() / "skating.bvh"};
  manifest.stimuli = {blend, file};
  Motions motions(manifest);
  const motion::Example& of_blend = motions.of("blend").motion;
  motion::Example settled = motions.of("file").motion;
  settled.clip = motion::with_settled_feet(settled.clip);
  EXPECT_EQ(motions.distance("blend", "file").mean, motion::distance(of_blend, settled).mean);
  EXPECT_NE(motions.distance("blend", "file").mean,
            motion::distance(of_blend, motions.of("file").motion).mean);
  EXPECT_EQ(motions.distance("file", "file").mean, 0.0);
}

TEST(RealWalks, AtTheirOwnRatingsAreThemselves) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "the real motion capture is not here";
  const Repertoire repertoire = load_repertoire(real_manifest(*data));
  ASSERT_EQ(repertoire.names.size(), 30u);
  EXPECT_FALSE(repertoire.simulated_ratings);
  expect_examples_at_their_own_parameters(
      repertoire,
      {"openness", "conscientiousness", "extraversion", "agreeableness", "neuroticism"});
}

TEST(RealWalks, ComeOutOfTheFootLockAtTheirOwnRatingsAsTheyAre) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "the real motion capture is not here";
  const Repertoire repertoire = load_repertoire(real_manifest(*data));
  ASSERT_EQ(repertoire.settled.examples.size(), 30u);
  for (int i = 0; i < 30; ++i) {
    const Stimulus stimulus = like_example(
        repertoire, i,
        {"openness", "conscientiousness", "extraversion", "agreeableness", "neuroticism"});
    const Synthesis made = synthesize(stimulus, repertoire);
    const motion::Example& settled = repertoire.settled.examples[static_cast<size_t>(i)];
    EXPECT_LT(motion::distance(settled, made.motion).mean, 1e-3) << settled.name;
    EXPECT_NEAR(made.weights[i], 1.0, 1e-9) << settled.name;
  }
}

/// The farthest that a joint or the tip of one is from where the other clip has it, metres.
double farthest_joint(const motion::Clip& a, const motion::Clip& b) {
  EXPECT_EQ(a.frame_count(), b.frame_count());
  double farthest = 0.0;
  for (std::size_t f = 0; f < std::min(a.poses.size(), b.poses.size()); ++f) {
    const motion::JointTransforms one = motion::world_transforms(a.body, a.poses[f]);
    const motion::JointTransforms other = motion::world_transforms(b.body, b.poses[f]);
    for (std::size_t j = 0; j < a.body.joints.size(); ++j) {
      const motion::Vec3 tip = a.body.joints[j].tip.value_or(motion::Vec3::Zero());
      const motion::Vec3 other_tip = b.body.joints[j].tip.value_or(motion::Vec3::Zero());
      farthest = std::max({farthest, (one.positions[j] - other.positions[j]).norm(),
                           (one.positions[j] + one.rotations[j] * tip - other.positions[j] -
                            other.rotations[j] * other_tip)
                               .norm()});
    }
  }
  return farthest;
}

TEST(RealMotions, BlendedAloneKeepEveryJointWithinFiveMillimetres) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "the real motion capture is not here";
  Manifest walks = real_manifest(*data);
  Manifest actors;
  actors.study = "actors";
  actors.examples.folder = *data / "mocap" / "aalto-two-actors";
  actors.ratings.source = Ratings::Source::none;
  for (const Manifest& manifest : {walks, actors}) {
    const Repertoire repertoire = load_repertoire(manifest);
    ASSERT_GE(repertoire.names.size(), 24u);
    for (const motion::Example& example : repertoire.settled.examples) {
      Stimulus stimulus;
      stimulus.id = "alone";
      stimulus.weights = {{example.name, 1.0}};
      stimulus.output.fps = example.clip.frames_per_second;
      EXPECT_LT(farthest_joint(synthesize(stimulus, repertoire).motion.clip, example.clip), 0.005)
          << example.name;
    }
  }
}

TEST(RealWalks, FeetStandStillInBlends) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "the real motion capture is not here";
  const Repertoire repertoire = load_repertoire(real_manifest(*data));
  for (double e : {0.25, 0.5, 0.75}) {
    for (double n : {0.3, 0.7}) {
      Stimulus stimulus;
      stimulus.adjectives = {{"extraversion", e}, {"neuroticism", n}};
      const Synthesis made = synthesize(stimulus, repertoire);
      EXPECT_LT(made.planted_drift_m, 0.005) << e << " " << n;
      // Measured again on what came out, with contacts found there.
      const auto plants = motion::foot_plants(made.motion.clip);
      EXPECT_GE(plants.size(), 2u);
      EXPECT_LT(motion::planted_drift(made.motion.clip, plants), 0.005) << e << " " << n;
    }
  }
}

// Fingers are blended where all examples with weight have them.
TEST(Synthesis, SaysThatFingersAreLeftOutWhereNotAllExamplesHaveThem) {
  Repertoire repertoire = load_repertoire(builtin_manifest());
  const auto made_of = [&](const NamedValues& weights) {
    Stimulus stimulus;
    stimulus.id = "a";
    stimulus.weights = weights;
    return synthesize(stimulus, repertoire);
  };
  const auto tells = [](const Synthesis& made) {
    return std::ranges::any_of(made.notes, [](const std::string& note) {
      return note.find("fingers of its examples are left out") != std::string::npos;
    });
  };
  const std::string& first = repertoire.names[0].name;
  const std::string& second = repertoire.names[1].name;
  EXPECT_FALSE(tells(made_of({{first, 0.5}, {second, 0.5}})));
  for (motion::ExampleSet* const set : {&repertoire.examples, &repertoire.settled})
    for (motion::Pose& pose : set->examples[0].clip.poses) pose.fingers = motion::relaxed_fingers();
  const Synthesis whole = made_of({{first, 1.0}});
  EXPECT_FALSE(tells(whole));
  EXPECT_TRUE(motion::has_fingers(whole.motion.clip));
  const Synthesis mixed = made_of({{first, 0.5}, {second, 0.5}});
  EXPECT_TRUE(tells(mixed));
  EXPECT_FALSE(motion::has_fingers(mixed.motion.clip));
}

}  // namespace
}  // namespace mien::pipeline
