#include "pipeline/study/studio/studio_motions.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/gait/contact.h"
#include "motion/live/live_core.h"
#include "motion/live/live_message.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/recording.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/studio/manifest_file.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// Of the motion behind the JSON: as many bytes as there should be.
std::string motion_in(const std::string& answer, std::size_t size) {
  std::uint32_t head = 0;
  std::memcpy(&head, answer.data(), 4);
  return answer.substr(4 + head, size);
}

/// The largest difference of the numbers of two answers; infinite where they are not alike
/// otherwise. (live_answer.h has the form.)
double difference_of(const std::string& one, const std::string& other) {
  constexpr std::size_t head = 6 * sizeof(std::uint32_t);
  if (one.size() != other.size() || one.substr(0, head) != other.substr(0, head)) return INFINITY;
  std::uint32_t frames = 0;
  std::memcpy(&frames, one.data() + 4, 4);
  const std::size_t end = one.size() - 2 * frames;
  double largest = 0.0;
  for (std::size_t at = head; at + sizeof(double) <= end; at += sizeof(double)) {
    double a = 0.0, b = 0.0;
    std::memcpy(&a, one.data() + at, sizeof a);
    std::memcpy(&b, other.data() + at, sizeof b);
    largest = std::max(largest, std::abs(a - b));
  }
  return largest;
}

/// Compares what the studio shows of each stimulus with what a run makes of it. The number of
/// stimuli; none where the manifest's files are not here.
std::size_t compared_through_both_doors(const fs::path& file) {
  const Environment none = [](const std::string&) { return std::nullopt; };
  const ManifestReading checked = check_manifest(file, none);
  // A stimulus with levels is shown without them.
  if (!checked.faults.empty() || !checked.manifest.origins.empty()) return 0;
  const ManifestFile opened(file, none);
  DraftReader reader(file, none);
  StudioMotions studio(reader);
  const nlohmann::ordered_json document = opened.state().document;
  Motions run(checked.manifest);
  std::size_t compared = 0;
  for (const Stimulus& stimulus : checked.manifest.stimuli) {
    if (!stimulus.people.empty()) continue;  // the studio shows one motion
    ++compared;
    const Synthesis& made = run.of(stimulus.id);
    const std::string expected = motion::to_message(
        motion::LiveMotion{made.motion, made.weights, motion::foot_plants(made.motion.clip)});
    const std::string name = file.filename().string() + ": " + stimulus.id;
    try {
      const std::string shown = studio.motion(document, stimulus.id, "");
      EXPECT_LT(difference_of(expected, motion_in(shown, expected.size())), 1e-9) << name;
    } catch (const DraftFaults& faults) {
      ADD_FAILURE() << name << ": " << faults.list().front().wrong;
    }
  }
  return compared;
}

TEST(StudioMotions, OfAllManifestsThatComeAlongAreThoseOfARun) {
  std::size_t compared = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(MIEN_SOURCE_DIR) / "manifests")) {
    if (entry.path().extension() == ".yaml") compared += compared_through_both_doors(entry.path());
  }
  EXPECT_GT(compared, 50u);
}

/// Whatever a motion goes by in another stimulus is there in the studio, too.
TEST(StudioMotions, GoByOtherStimuliAsARunDoes) {
  const test::TemporaryFolder folder;
  const auto compared = [&](const std::string& stimuli) {
    write_file(
        folder.path() / "m.yaml",
        "mien: 1\nstudy: s\nseed: 7\nexamples: {set: builtin:walks-10}\nstimuli:\n" + stimuli);
    return compared_through_both_doors(folder.path() / "m.yaml");
  };
  EXPECT_EQ(compared("  - {id: others, adjectives: {quickness: 0.6}, hold: others}\n"
                     "  - {id: named, adjectives: {quickness: 0.4}, hold: [largeness]}\n"
                     "  - {id: given, adjectives: {quickness: 0.4}, hold: {largeness: 0.4}}\n"
                     "  - {id: walked, role: reference, path: [{walk: 1}]}\n"
                     "  - {id: first, role: reference, weights: {sad: 1}}\n"
                     "  - {id: second, role: reference, adjectives: {quickness: 0.5}, hold: "
                     "others}\n"),
            6u);
  EXPECT_EQ(compared("  - {id: a, adjectives: {quickness: 0.6}, hold: others}\n"), 1u);
  EXPECT_EQ(
      compared("  - {id: r, role: reference, adjectives: {largeness: 0.6}, hold: others}\n"
               "  - {id: a, adjectives: {quickness: 0.6}, hold: others, modify: {emotion: sad}}\n"
               "  - {id: f, foil: {of: a, differ: posture}}\n"),
      3u);
  // Sounds and the design are not those of one motion.
  write_file(folder.path() / "s.wav", "RIFF");
  EXPECT_EQ(compared("  - {id: a, weights: {sad: 1}, audio: s.wav, factors: {mood: sad}}\n"
                     "  - {id: b, weights: {happy: 1}, audio: {from: a}}\n"
                     "design: {alike: [mood]}\n"),
            2u);
}

TEST(StudioMotions, OfAStimulusWithLevelsAreAsWithoutThem) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "m.yaml";
  const Environment none = [](const std::string&) { return std::nullopt; };
  const auto shown = [&](const char* id, const std::string& rest) {
    write_file(file, "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n  - {id: " +
                         std::string(id) + ", weights: {normal: 1}, modify: {emotion: sad}" + rest +
                         "}\n");
    const ManifestFile opened(file, none);
    DraftReader reader(file, none);
    StudioMotions studio(reader);
    return studio.motion(opened.state().document, id, "");
  };
  const std::string levels = ", levels: {factor: d, of: modify.strength, values: [0.5, 1]}";
  const std::string with = shown("a", levels), without = shown("a", "");
  const std::size_t size = with.size() - with.rfind("MOVE");
  EXPECT_GT(size, 10000u);
  EXPECT_EQ(difference_of(motion_in(with, size), motion_in(without, size)), 0.0);
}

/// A studio is open for hours, while recordings and recipes are edited.
TEST(StudioMotions, AreMadeAgainWhenAFileThatTheyAreMadeFromChanges) {
  const test::TemporaryFolder folder;
  const motion::ExampleSet walks = motion::builtin_examples("walks-10");
  fs::file_time_type time = fs::file_time_type::clock::now();
  const auto touch = [&](const std::string& file) {
    fs::last_write_time(folder.path() / file, time += std::chrono::seconds(1));
  };
  const auto save_walk = [&](const std::string& file, std::size_t walk) {
    motion::write_motion(motion::to_recording(walks.examples[walk].clip), folder.path() / file);
    touch(file);
  };
  const auto save_recipe = [&](const std::string& tempo) {
    write_file(folder.path() / "my.recipes.yaml", "recipes: {calm: {tempo: " + tempo + "}}\n");
    touch("my.recipes.yaml");
  };
  fs::create_directories(folder.path() / "captures");
  save_walk("captures/normal.bvh", 0);
  save_walk("captures/other.bvh", 1);
  save_walk("walk.bvh", 0);
  save_recipe("0.9");
  const fs::path file = folder.path() / "m.yaml";
  write_file(file,
             "mien: 1\nstudy: s\nrecipes: my.recipes.yaml\n"
             "examples: {set: {folder: captures, cycle: whole}, ratings: simulated}\nstimuli:\n"
             "  - {id: captured, clip: walk.bvh}\n"
             "  - {id: blended, weights: {other: 1}}\n"
             "  - {id: modified, weights: {normal: 1}, modify: {emotion: calm}}\n"
             "  - {id: pair, people: [{clip: walk.bvh}, {weights: {normal: 1}, place: {x: 1}}]}\n");
  const Environment none = [](const std::string&) { return std::nullopt; };
  const nlohmann::ordered_json document = ManifestFile(file, none).state().document;
  DraftReader reader(file, none);
  StudioMotions studio(reader);
  const auto motion_of = [&](const std::string& id) {
    const std::string answer = studio.motion(document, id, "");
    return answer.substr(answer.find("MOVE"));
  };
  const auto motions = [&] {
    std::map<std::string, std::string> all;
    for (const char* id : {"captured", "blended", "modified", "pair"}) all[id] = motion_of(id);
    return all;
  };
  const auto changed = [&](const auto& change) {
    const auto before = motions();
    change();
    std::string names;
    for (const auto& [id, motion] : motions())
      if (before.at(id) != motion) names += id + " ";
    return names;
  };
  EXPECT_EQ(changed([] {}), "");
  EXPECT_EQ(changed([&] { save_walk("walk.bvh", 1); }), "captured pair ");
  EXPECT_EQ(changed([&] { save_recipe("0.8"); }), "modified ");
  // All examples are retargeted to one body.
  EXPECT_EQ(changed([&] { save_walk("captures/other.bvh", 2); }), "blended modified pair ");
  save_walk("captures/third.bvh", 3);
  EXPECT_EQ(studio.choices(document)["examples"].size(), 3u);
}

}  // namespace
}  // namespace mien::pipeline
