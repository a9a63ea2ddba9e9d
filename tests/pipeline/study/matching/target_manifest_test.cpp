#include "pipeline/study/matching/target_manifest.h"

#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

TargetSet two_targets(bool are_features) {
  TargetSet set;
  set.parameters = are_features ? std::vector<std::string>{"step-length", "lateral-swing"}
                                : std::vector<std::string>{"quickness", "sad-happy"};
  set.are_features = are_features;
  set.seed = 9;
  for (const char* id : {"target-1", "practice-1"}) {
    SampledTarget target;
    target.id = id;
    target.practice = set.targets.size() == 1;
    target.place = Eigen::RowVector2d(0.125, set.targets.empty() ? 0.75 : 1.0);
    set.targets.push_back(target);
  }
  return set;
}

const Environment nothing_set = [](const std::string&) { return std::optional<std::string>(); };

std::string told(const ManifestReading& reading) {
  std::string text;
  for (const Fault& fault : reading.faults) text += to_string(fault) + "\n";
  return text;
}

TEST(TargetManifest, IsReadAgainAsItWasMeant) {
  Manifest source;
  source.seed = 4;
  source.examples.builtin = "walks-27";
  source.ratings.source = Ratings::Source::simulated;
  source.ratings.raters = 20;
  const ManifestReading reading = parse_manifest(
      target_manifest_yaml(target_manifest(source, two_targets(false)), two_targets(false), "."),
      "targets.yaml", nothing_set);
  EXPECT_EQ(told(reading), "");
  const Manifest& manifest = reading.manifest;
  EXPECT_EQ(manifest.seed, 4u);
  EXPECT_EQ(manifest.examples.builtin, "walks-27");
  EXPECT_EQ(manifest.ratings.source, Ratings::Source::simulated);
  EXPECT_EQ(manifest.ratings.raters, 20);
  ASSERT_EQ(manifest.stimuli.size(), 2u);
  EXPECT_EQ(manifest.stimuli[0].id, "target-1");
  EXPECT_EQ(manifest.stimuli[0].role, Role::target);
  EXPECT_EQ(manifest.stimuli[0].adjectives,
            (NamedValues{{"quickness", 0.125}, {"sad-happy", 0.75}}));
}

TEST(TargetManifest, FindsItsFilesFromWhereverItLies) {
  const test::TemporaryFolder folder;
  const fs::path captures = folder.path() / "my \"${captures}";
  fs::create_directories(captures);
  fs::create_directories(folder.path() / "out");
  write_file(folder.path() / "answers.csv", "stimulus,scale,value\n");
  Manifest source;
  source.examples.folder = captures;
  source.examples.include = "*walk*.bvh";
  source.examples.exclude = "*run*";
  source.examples.cycle = motion::CycleChoice::start_peak_end;
  source.examples.keytimes = {{"a walk", {0.1, 0.75}}};
  source.examples.given_labels = {{"a walk", "calm"}};
  source.ratings.source = Ratings::Source::file;
  source.ratings.file = folder.path() / "answers.csv";
  const fs::path file = folder.path() / "out" / "targets.yaml";
  const ManifestReading reading =
      parse_manifest(target_manifest_yaml(target_manifest(source, two_targets(true)),
                                          two_targets(true), file.parent_path()),
                     file, nothing_set);
  EXPECT_EQ(told(reading), "");
  const Examples& examples = reading.manifest.examples;
  EXPECT_TRUE(fs::equivalent(examples.folder, captures));
  EXPECT_TRUE(fs::equivalent(reading.manifest.ratings.file, source.ratings.file));
  EXPECT_EQ(examples.include, "*walk*.bvh");
  EXPECT_EQ(examples.exclude, "*run*");
  EXPECT_EQ(examples.cycle, motion::CycleChoice::start_peak_end);
  EXPECT_EQ(examples.keytimes, source.examples.keytimes);
  EXPECT_EQ(examples.given_labels, source.examples.given_labels);
  EXPECT_EQ(reading.manifest.stimuli[1].features,
            (NamedValues{{"step-length", 0.125}, {"lateral-swing", 1.0}}));
}

}  // namespace
}  // namespace mien::pipeline
