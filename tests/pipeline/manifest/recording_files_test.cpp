#include "pipeline/manifest/recording_files.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/recording.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> nothing(const std::string&) { return std::nullopt; }

class RecordingFiles : public testing::Test {
 protected:
  RecordingFiles() {
    fs::create_directories(folder / "captures");
    const motion::Recording walk =
        motion::to_recording(motion::walk({}, 30.0, motion::standard_body()).clip);
    for (const char* name : {"captures/a.bvh", "captures/b.bvh", "c.bvh"})
      motion::write_motion(walk, folder / name);
  }

  ManifestReading read(const std::string& stimuli, const std::string& examples = "") const {
    const fs::path file = folder / "m.yaml";
    write_file(file, "mien: 1\nstudy: s\n" + examples + "stimuli:\n" + stimuli);
    return check_manifest(file, nothing);
  }
  Manifest manifest(const std::string& stimuli, const std::string& examples = "") const {
    const ManifestReading reading = read(stimuli, examples);
    if (!reading.faults.empty()) ADD_FAILURE() << Faults(reading.faults).what();
    return reading.manifest;
  }
  std::vector<std::string> faults(const std::string& stimuli,
                                  const std::string& examples = "") const {
    std::vector<std::string> lines;
    for (const Fault& fault : read(stimuli, examples).faults) {
      const std::string line = to_string(fault);
      lines.push_back(line.substr(line.find("m.yaml") + 7));
    }
    return lines;
  }

  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
};

TEST_F(RecordingFiles, HaveTheLicenceThatIsStatedAnywhere) {
  const Manifest found = manifest(
      "  - {id: a, clip: {file: captures/a.bvh, licence: CC BY 4.0, source: example.org}}\n"
      "  - {id: a2, clip: captures/a.bvh, modify: {tempo: 0.9}}\n"
      "  - {id: c, clip: {file: c.bvh, licence: {name: AMASS licence, share: false}}}\n");
  const std::vector<RecordingFile> files = recording_files(found);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].file, folder / "c.bvh");
  EXPECT_EQ(files[0].licence, (Licence{"AMASS licence", false}));
  EXPECT_EQ(files[1].licence, (Licence{"CC BY 4.0", true}));
  EXPECT_EQ(files[1].source, "example.org");
  EXPECT_TRUE(restricting_licences(found.stimuli[0], files).empty());
  EXPECT_EQ(restricting_licences(found.stimuli[2], files),
            std::vector<std::string>{"AMASS licence"});
}

TEST_F(RecordingFiles, RestrictAllThatIsMadeFromThem) {
  const std::string restricted = "licence: {name: mine, share: false}";
  const Manifest found = manifest(
      "  - {id: blend, weights: {a: 1, b: 1}}\n"
      "  - {id: posed, clip: c.bvh, modify: {pose: {neutral: {motion: captures/a.bvh, frame: 0}, "
      "posed: {motion: captures/a.bvh, frame: 3}}}}\n"
      "  - {id: own, clip: c.bvh}\n"
      "  - {id: styled, clip: c.bvh, modify: {method: amaya, neutral: a, styled: b}}\n",
      "examples: {ratings: none, set: {folder: captures, cycle: whole, " + restricted + "}}\n");
  const std::vector<RecordingFile> files = recording_files(found);
  const auto licences = [&](std::size_t i) {
    return restricting_licences(found.stimuli[i], files);
  };
  EXPECT_EQ(licences(0), std::vector<std::string>{"mine"});
  EXPECT_EQ(licences(1), std::vector<std::string>{"mine"});
  EXPECT_EQ(licences(2), std::vector<std::string>());
  EXPECT_EQ(licences(3), std::vector<std::string>{"mine"});
}

TEST_F(RecordingFiles, StatedInTwoWaysAreAFault) {
  EXPECT_EQ(
      faults("  - {id: a, clip: {file: c.bvh, licence: CC0}}\n"
             "  - {id: b, clip: {file: c.bvh, licence: {name: CC0, share: false}}}\n"
             "  - {id: c, clip: {file: ./c.bvh, licence: CC0, source: x}}\n"
             "  - {id: d, clip: {file: c.bvh, source: y}}\n"),
      (std::vector<std::string>{
          "5:42: stimuli[1].clip.licence: c.bvh has the licence \"CC0\" in stimuli[0].clip; "
          "state the same licence, or only one",
          "7:41: stimuli[3].clip.source: c.bvh has the source \"x\" in stimuli[2].clip; state "
          "the same source, or only one"}));
}

TEST_F(RecordingFiles, WithBadLicencesAreRefused) {
  for (const char* licence : {"''", "3", "[CC0]", "{share: false}", "{name: CC0, share: maybe}",
                              "{name: CC0, shared: false}", "{name: ''}", "true"}) {
    const std::vector<std::string> found =
        faults(std::string("  - {id: a, clip: {file: c.bvh, licence: ") + licence + "}}\n");
    EXPECT_EQ(found.size(), 1u) << licence;
    if (!found.empty()) {
      EXPECT_NE(found[0].find("stimuli[0].clip.licence"), std::string::npos) << found[0];
    }
  }
}

TEST_F(RecordingFiles, OfExamplesHaveTheirLicenceAtTheFolder) {
  const std::vector<std::string> found = faults(
      "  - {id: a, weights: {normal: 1}, modify: {pose: {neutral: {motion: normal, licence: CC0}, "
      "posed: sad}}}\n",
      "examples: {set: builtin:walks-10}\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("\"normal\" is an example; state it in examples.set"), std::string::npos)
      << found[0];
}

}  // namespace
}  // namespace mien::pipeline
