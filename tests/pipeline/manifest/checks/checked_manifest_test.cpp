#include "pipeline/manifest/checks/checked_manifest.h"

#include <filesystem>
#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/document_checks.h"

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
    for (const Fault& fault : check_manifest(file, environment).faults)
      ADD_FAILURE() << to_string(fault);
    ++checked;
  }
  EXPECT_GE(checked, 5);
  if (!data) GTEST_SKIP() << "the real motion capture is not here; manifests on it were excluded";
}

}  // namespace
}  // namespace mien::pipeline
