#include "pipeline/production/design/design_findings.h"

#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// What is said of a study of these stimuli whose durations are equalized.
std::string said_of(const std::string& stimuli) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "m.yaml";
  write_file(file,
             "mien: 1\nstudy: s\noutput: {fps: 30}\nequalize: [duration]\nstimuli:\n" + stimuli);
  const Manifest manifest = load_manifest(file, [](const std::string&) { return std::nullopt; });
  Motions motions(manifest);
  std::string said;
  for (const DesignWarning& warning : design_warnings(manifest, planned_design(manifest, motions)))
    said += warning.path + ": " + to_sentence(warning) + "\n";
  return said;
}

TEST(DesignFindings, WarnWhereEqualDurationsCutMostOfAFilm) {
  EXPECT_EQ(said_of("  - {id: a, path: [{walk: 3}]}\n  - {id: b, path: [{walk: 4}]}\n"), "");
  const std::string cut = said_of(
      "  - {id: long, path: [{walk: 8}]}\n  - {id: longer, path: [{walk: 9}, {stand: 1}]}\n"
      "  - {id: short, path: [{stand: 0.5}]}\n");
  EXPECT_TRUE(cut.starts_with("equalize: equalizing durations cuts \"longer\" from ")) << cut;
  EXPECT_NE(cut.find(" s, the duration of \"short\", and 1 more film by"), std::string::npos)
      << cut;
  EXPECT_NE(cut.find("; leave out \"short\", or do not equalize durations\n"), std::string::npos)
      << cut;
}

}  // namespace
}  // namespace mien::pipeline
