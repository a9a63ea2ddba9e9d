#include "pipeline/study/questionnaire/experiment/restricted_motions.h"

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/recording.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class RestrictedMotions : public testing::Test {
 protected:
  RestrictedMotions() {
    const motion::Recording walk =
        motion::to_recording(motion::walk({}, 30.0, motion::standard_body()).clip);
    for (const char* name : {"own.bvh", "lent.bvh"}) motion::write_motion(walk, folder / name);
  }

  /// The faults of a study with a stimulus of each file.
  std::vector<std::string> told(const std::string& section) const {
    const fs::path file = folder / "m.yaml";
    write_file(file,
               "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10, ratings: builtin}\n"
               "output: {clips: [bvh, glb]}\nstimuli:\n"
               "  - {id: free, role: target, clip: own.bvh}\n"
               "  - {id: lent, role: target, clip: {file: lent.bvh, licence: {name: Lab 7, "
               "share: false}}}\n" +
                   section);
    const ManifestReading reading =
        check_manifest(file, [](const std::string&) { return std::nullopt; });
    if (!reading.faults.empty()) ADD_FAILURE() << Faults(reading.faults).what();
    std::vector<std::string> lines;
    for (const Fault& fault : restricted_motions(reading.manifest)) {
      const std::string line = to_string(fault);
      lines.push_back(line.substr(line.find("m.yaml") + 7));
    }
    return lines;
  }

  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
};

TEST_F(RestrictedMotions, AreSentToBrowsersThatTurnThem) {
  const std::vector<std::string> lines =
      told("questionnaire: {participants: 2, scales: all, view: turn}\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].starts_with("7:")) << lines[0];
  EXPECT_NE(lines[0].find("\"Lab 7\" does not permit sharing the motion of \"lent\""),
            std::string::npos)
      << lines[0];
}

TEST_F(RestrictedMotions, AreNotSentAsVideosOrWhenNotShown) {
  EXPECT_TRUE(told("questionnaire: {participants: 2, scales: all}\n").empty());
  EXPECT_TRUE(
      told("questionnaire: {participants: 2, scales: all, view: turn, stimuli: [free]}\n").empty());
}

TEST_F(RestrictedMotions, AreSentByMatchingExperiments) {
  const std::vector<std::string> lines =
      told("matching: {participants: 2, targets: [free, lent]}\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("\"lent.bvh\", but the experiment"), std::string::npos) << lines[0];
}

}  // namespace
}  // namespace mien::pipeline
