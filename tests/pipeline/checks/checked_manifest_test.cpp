#include "pipeline/checks/checked_manifest.h"

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/checks/document_checks.h"
#include "pipeline/documents/files.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

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
    if (kind_of_document(read_file(file), file.filename().string()) != DocumentKind::manifest)
      continue;
    if (file.filename().string().starts_with("real-") && !data) continue;
    for (const Fault& fault : check_manifest(file, environment).faults)
      ADD_FAILURE() << to_string(fault);
    ++checked;
  }
  EXPECT_GE(checked, 5);
  if (!data) GTEST_SKIP() << "the real motion capture is not here; manifests on it were left out";
}

}  // namespace
}  // namespace mien::pipeline
