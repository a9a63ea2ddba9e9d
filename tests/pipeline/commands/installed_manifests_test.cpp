#include "pipeline/commands/line/installed_manifests.h"

#include <fstream>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// A folder of manifests as they are installed, of empty files.
void make_manifests(const fs::path& folder) {
  fs::create_directories(folder / "pictures");
  for (const char* name : {"mien.schema.json", "walk.yaml", "real-walks.yaml", "five.scales.yaml",
                           "my.recipes.yaml"}) {
    std::ofstream(folder / name) << "";
  }
}

TEST(InstalledManifests, LieBesideTheProgramWhateverThePrefix) {
  const TemporaryFolder scratch;
  make_manifests(scratch.path() / "any where/share/mien/manifests");
  EXPECT_EQ(manifests_beside(scratch.path() / "any where/bin/mien"),
            scratch.path() / "any where/share/mien/manifests");
}

TEST(InstalledManifests, AreTheTreesWhereTheProgramWasBuilt) {
  const TemporaryFolder scratch;
  make_manifests(scratch.path() / "tree/manifests");
  EXPECT_EQ(manifests_beside(scratch.path() / "tree/build/release/mien"),
            scratch.path() / "tree/manifests");
  EXPECT_EQ(manifests_beside(scratch.path() / "elsewhere/build/release/mien"), fs::path());
}

TEST(InstalledManifests, AreCalledByTheirNames) {
  const TemporaryFolder scratch;
  make_manifests(scratch.path());
  EXPECT_EQ(manifest_names(scratch.path()), (std::vector<std::string>{"real-walks", "walk"}));
  EXPECT_EQ(manifest_names(scratch.path() / "nowhere"), std::vector<std::string>{});
}

TEST(InstalledManifests, AreFoundWithAndWithoutFolderAndEnding) {
  const TemporaryFolder scratch;
  make_manifests(scratch.path());
  for (const char* name : {"walk", "walk.yaml", "manifests/walk", "manifests/walk.yaml"}) {
    EXPECT_EQ(find_named_file(scratch.path(), name), scratch.path() / "walk.yaml") << name;
  }
  EXPECT_EQ(find_named_file(scratch.path(), "five.scales"), scratch.path() / "five.scales.yaml");
}

TEST(InstalledManifests, AreNotTakenForFilesOfOtherFolders) {
  const TemporaryFolder scratch;
  make_manifests(scratch.path());
  for (const char* name : {"", ".", "..", "my/walk.yaml", "/walk.yaml", "./walk.yaml", "pictures",
                           "manifests/", "../manifests/walk.yaml", "wal"}) {
    EXPECT_EQ(find_named_file(scratch.path(), name), std::nullopt) << name;
  }
  EXPECT_EQ(find_named_file({}, "walk"), std::nullopt);
}

}  // namespace
}  // namespace mien::pipeline
