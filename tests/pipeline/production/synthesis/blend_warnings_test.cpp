#include "pipeline/production/synthesis/blend_warnings.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/examples/make_example.h"
#include "motion/formats/motion_file.h"
#include "motion/gait/contact.h"
#include "motion/lint/injected_faults.h"
#include "motion/procedural/builtin_sets.h"
#include "pipeline/manifest/reading/example_source.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

using motion::Clip;

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text + "\n";
  return all;
}

bool holds(const std::vector<std::string>& texts, const std::string& part) {
  return joined(texts).find(part) != std::string::npos;
}

Clip walk() { return motion::repeated(motion::builtin_examples("walks-10").examples[0].clip, 4); }

std::vector<std::string> warnings_of_clip(const Clip& clip) {
  Synthesis synthesis;
  synthesis.findings = motion::lint(clip);
  return blend_warnings({}, synthesis);
}

TEST(BlendWarnings, TellOfFeetThatSlideSinkOrHang) {
  EXPECT_TRUE(warnings_of_clip(walk()).empty()) << joined(warnings_of_clip(walk()));
  Clip sliding = walk();
  std::vector<motion::FootPlant> plants = motion::foot_plants(sliding);
  const auto plant = std::ranges::find_if(
      plants, [](const motion::FootPlant& one) { return one.first > 20 && one.left; });
  ASSERT_NE(plant, plants.end());
  test::slide(sliding, *plant, motion::Vec3(0.12, 0.0, 0.0));
  EXPECT_TRUE(holds(warnings_of_clip(sliding), "The planted left foot slides by"))
      << joined(warnings_of_clip(sliding));
  for (const auto& [metres, words] : {std::pair(-0.05, "sinks"), std::pair(0.06, "floats")}) {
    Clip moved = walk();
    for (motion::Pose& pose : moved.poses) pose.root_position.y() += metres;
    EXPECT_TRUE(holds(warnings_of_clip(moved), words)) << joined(warnings_of_clip(moved));
  }
}

/// A foot that sinks at every step is told of once, as it sinks deepest.
TEST(BlendWarnings, TellOfEachFootOnceAndOfNothingButFeet) {
  Clip clip = walk();
  for (std::size_t t = 0; t < clip.poses.size(); ++t)
    clip.poses[t].root_position.y() -= 0.02 + 0.0001 * static_cast<double>(t);
  test::leap(clip, motion::Head, 30, 60.0, motion::Vec3::UnitX());
  Synthesis synthesis;
  synthesis.findings = motion::lint(clip);
  double deepest = 0.0;
  std::size_t sinking = 0;
  for (const motion::Finding& finding : synthesis.findings) {
    if (finding.check != "penetration" || finding.joint != "LeftAnkle") continue;
    deepest = std::max(deepest, finding.measured);
    ++sinking;
  }
  ASSERT_GT(sinking, 1u);
  const std::vector<std::string> warnings = blend_warnings({}, synthesis);
  const auto of_left = std::ranges::count_if(warnings, [](const std::string& warning) {
    return warning.find("The left foot sinks") != std::string::npos;
  });
  EXPECT_EQ(of_left, 1);
  const auto worst = std::ranges::find_if(synthesis.findings, [&](const motion::Finding& finding) {
    return finding.joint == "LeftAnkle" && finding.measured == deepest;
  });
  EXPECT_TRUE(holds(warnings, worst->sentence)) << joined(warnings);
  EXPECT_FALSE(holds(warnings, "head")) << joined(warnings);
}

/// A part of a walk, shorter than a cycle, in which a step is found and no cycle.
std::optional<Clip> single_step() {
  const Clip walk = motion::repeated(motion::builtin_examples("walks-10").examples[4].clip, 3);
  const double cycle = walk.frame_count() / 3.0;
  for (double length = 0.7; length < 1.3; length += 0.05) {
    for (double start = 0.1; start < 1.1; start += 0.1) {
      Clip part = walk;
      const auto first = walk.poses.begin() + static_cast<int>(start * cycle);
      part.poses = {first, first + static_cast<int>(length * cycle)};
      const motion::PreparedExample prepared = motion::prepare_example(part);
      if (prepared.cycle && prepared.cycle->is_half) return part;
    }
  }
  return std::nullopt;
}

class BlendOfFiles : public testing::Test {
 protected:
  /// A whole walk, and one that ends before its cycle does.
  BlendOfFiles() {
    const Clip whole = walk();
    const std::optional<Clip> step = single_step();
    if (!step) throw std::logic_error("no part of the walk is a single step");
    motion::write_motion(motion::to_recording(whole), folder_.path() / "whole.bvh");
    motion::write_motion(motion::to_recording(*step), folder_.path() / "step.bvh");
    Manifest manifest;
    manifest.examples = parse_examples(folder_.path().string());
    repertoire_ = load_repertoire(manifest);
  }

  std::vector<std::string> warnings_with(const NamedValues& weights) const {
    Stimulus stimulus;
    stimulus.id = "blend";
    stimulus.weights = weights;
    return blend_warnings(repertoire_, synthesize(stimulus, repertoire_));
  }

  test::TemporaryFolder folder_;
  Repertoire repertoire_;
};

TEST_F(BlendOfFiles, TellsOfAStepThatStandsForACycleWhereItHasAShare) {
  const char* mirrored = "step: The take contains no full cycle; one step and its mirror image";
  ASSERT_TRUE(holds(repertoire_.warnings, mirrored)) << joined(repertoire_.warnings);
  EXPECT_TRUE(holds(warnings_with({{"step", 1.0}}), mirrored));
  EXPECT_TRUE(holds(warnings_with({{"step", 0.1}, {"whole", 0.9}}), mirrored));
  const std::vector<std::string> without = warnings_with({{"whole", 1.0}});
  EXPECT_FALSE(holds(without, "step: ")) << joined(without);
}

}  // namespace
}  // namespace mien::pipeline
