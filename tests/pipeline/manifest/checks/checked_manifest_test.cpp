#include "pipeline/manifest/checks/checked_manifest.h"

#include <filesystem>
#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/temporary_folder.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// Whether it does so in more than a comment.
bool names_recordings(const std::string& manifest) {
  std::istringstream lines(manifest);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#') && line.find("${MIEN_DATA") != std::string::npos) return true;
  }
  return false;
}

TEST(ShippedManifests, HaveNoFaults) {
  const auto data = test::real_data();
  const auto environment = [&](const std::string& name) -> std::optional<std::string> {
    if (name == "MIEN_DATA" && data) return data->string();
    return std::nullopt;
  };
  int checked = 0;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(MIEN_SOURCE_DIR) / "manifests")) {
    const fs::path& file = entry.path();
    if (file.extension() != ".yaml") continue;
    const std::string text = read_file(file);
    if (kind_of_document(text, file.filename().string()) != DocumentKind::manifest) continue;
    if (names_recordings(text) && !data) continue;
    const ManifestReading reading = check_manifest(file, environment);
    for (const Fault& fault : reading.faults) ADD_FAILURE() << to_string(fault);
    for (const Fault& warning : reading.manifest.renamed) ADD_FAILURE() << to_string(warning);
    ++checked;
  }
  EXPECT_GE(checked, 5);
  if (!data) GTEST_SKIP() << "the real motion capture is not here; manifests on it were excluded";
}

TEST(CheckedManifest, IsReadWithoutWarningsFromTheRecordOfAStudyMadeWithFormerNames) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "provenance.json",
             R"({"mien": "0.2.0", "manifest": {"as_run": "as_run.yaml", "copy": "as_run.yaml"}})");
  write_file(folder.path() / "as_run.yaml", R"(mien: 1
study: s
examples: {set: builtin:walks-10}
look: {figure: {trail: {before: 2, faintest: 0.3}}}
stimuli: [{id: a, weights: {sad: 1}}]
)");
  const ManifestReading reading =
      check_manifest(folder.path() / "provenance.json", process_environment());
  for (const Fault& fault : reading.faults) ADD_FAILURE() << to_string(fault);
  EXPECT_TRUE(reading.manifest.renamed.empty());
  EXPECT_EQ(std::get<scenes::TrailOptions>(reading.manifest.look.figure).min_opacity, 0.3);
}

}  // namespace
}  // namespace mien::pipeline
