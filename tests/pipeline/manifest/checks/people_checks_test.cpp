#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/recording.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// Faults of a manifest with these stimuli, beside a file walk.bvh.
class PeopleChecks : public testing::Test {
 protected:
  PeopleChecks() {
    const motion::Clip walk = motion::builtin_examples("walks-10").examples.front().clip;
    motion::write_motion(motion::to_recording(walk), folder_.path() / "walk.bvh");
  }

  std::string faults(const std::string& stimuli, const std::string& others = "") const {
    const std::filesystem::path file = folder_.path() / "m.yaml";
    const std::string text =
        "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n" + others + "stimuli:\n" + stimuli;
    const ManifestReading reading =
        check_manifest_text(text, file, [](const std::string&) { return std::nullopt; });
    return reading.faults.empty() ? "" : Faults(reading.faults).what();
  }

  void expect(const std::string& stimuli, const std::string& place, const std::string& wrong,
              const std::string& others = "") const {
    const std::string found = faults(stimuli, others);
    EXPECT_NE(found.find("m.yaml:" + place + ": "), std::string::npos) << place << "\n" << found;
    EXPECT_NE(found.find(wrong), std::string::npos) << found;
  }

 private:
  test::TemporaryFolder folder_;
};

constexpr char sad[] = "{weights: {sad: 1}, place: {x: -1}}";
constexpr char happy[] = "{weights: {happy: 1}, place: {x: 1}}";

std::string pair_of(const std::string& one, const std::string& other,
                    const std::string& more = "") {
  return "  - id: greet\n    people:\n      - " + one + "\n      - " + other + "\n" + more;
}

TEST_F(PeopleChecks, AcceptPeopleOfEveryKindOfMotion) {
  EXPECT_EQ(faults(pair_of(sad, happy)), "");
  EXPECT_EQ(
      faults(pair_of("{clip: walk.bvh}", "{clip: walk.bvh}", "      - {path: [{walk: 1}]}\n")), "");
  EXPECT_EQ(faults(pair_of("{adjectives: {quickness: 0.6}, place: {}}",
                           "{clip: walk.bvh, place: {x: 1}, modify: {emotion: sad}}",
                           "    look: {figure: point-light}\n")),
            "");
}

TEST_F(PeopleChecks, RefuseAStimulusWithAMotionOfItsOwn) {
  expect(pair_of(sad, happy, "    weights: {sad: 1}\n"), "5:5",
         "weights and people exclude each other");
  expect(pair_of(sad, happy, "    modify: {emotion: sad}\n"), "9:5",
         "a stimulus with people has no motion of its own");
}

TEST_F(PeopleChecks, RefuseOnePersonAndNine) {
  expect(std::string("  - {id: greet, people: [") + sad + "]}\n", "5:25", "2");
  std::string nine;
  for (int i = 0; i < 9; ++i) nine += std::string(sad) + ", ";
  expect("  - {id: greet, people: [" + nine + "]}\n", "5:25", "8");
}

TEST_F(PeopleChecks, RefuseNamesThatAreTaken) {
  expect(pair_of("{name: b, weights: {sad: 1}, place: {}}", happy), "8:9",
         "\"b\" is already the name of another person");
  expect(pair_of(sad, happy) + "  - {id: greet.a, weights: {sad: 1}}\n", "7:9",
         "\"greet.a\" is already the id of stimuli[1]");
}

TEST_F(PeopleChecks, RefusePeopleWhosePlaceIsOpen) {
  expect(pair_of("{weights: {sad: 1}}", happy), "7:9", "\"a\" has no place on the stage");
  expect(pair_of("{clip: walk.bvh}", "{clip: walk.bvh, place: {x: 1}}"), "7:9",
         "\"a\" has no place, but another person from a file has one");
}

TEST_F(PeopleChecks, RefuseLooksOfOnePerson) {
  expect(pair_of(sad, happy, "    look: {figure: trail}\n"), "9:20",
         "a trail shows one motion only");
  expect(pair_of(sad, happy, "    look: {scene: treadmill}\n"), "5:5",
         "the ground of this set moves with one walker only");
  expect(pair_of(sad, "{weights: {happy: 1}, place: {}, look: {figure: mannequin}}",
                 "    look: {figure: point-light}\n"),
         "8:57", "bodies and dots are not shown together");
}

TEST_F(PeopleChecks, ReportFaultsOfAPersonsMotionAtItsPlace) {
  expect(pair_of("{weights: {sadd: 1}, place: {}}", happy), "7:20", "did you mean \"sad\"?");
  expect(pair_of("{clip: none.bvh}", "{clip: walk.bvh}"), "7:16", "none.bvh");
  expect(pair_of("{weights: {sad: 1}, place: {}, modify: {emotion: saad}}", happy), "7:58",
         "there is no recipe for \"saad\"");
  expect(pair_of("{adjectives: {quicknes: 0.4}, place: {}}", happy), "7:23",
         "did you mean \"quickness\"?");
}

TEST_F(PeopleChecks, RefuseWhatNeedsOneMotion) {
  expect(pair_of(sad, happy) + "  - {id: f, foil: {of: greet, differ: posture}}\n", "9:24",
         "\"greet\" has several people, each with a motion");
  expect(pair_of(sad, happy) + "sheets: [{compare: {target: greet, created: greet.b}}]\n", "9:29",
         "\"greet\" has several people, each with a motion; name one of them, such as greet.a");
  EXPECT_EQ(
      faults(pair_of(sad, happy) + "sheets: [{compare: {target: greet.a, created: greet.b}}]\n"),
      "");
  expect(pair_of(sad, happy) + "  - {id: t, role: target, weights: {sad: 1}}\n", "8:7",
         "sliders make one motion, but this stimulus has several people",
         "matching: {participants: 4, targets: [greet]}\n");
}

}  // namespace
}  // namespace mien::pipeline
