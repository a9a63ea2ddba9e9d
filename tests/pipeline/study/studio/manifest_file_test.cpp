#include "pipeline/study/studio/manifest_file.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

const std::string quickstart =
    read_file(fs::path(MIEN_SOURCE_DIR) / "manifests" / "quickstart.yaml");

class OpenedManifest : public testing::Test {
 protected:
  OpenedManifest() { write_file(file_, quickstart); }

  static ordered_json brisker(ordered_json document) {
    document["stimuli"][0]["adjectives"]["quickness"] = 0.9;
    return document;
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "my.yaml";
};

TEST_F(OpenedManifest, IsSavedWithTheChangeAndNothingElse) {
  ManifestFile opened(file_, process_environment());
  fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write);
  const ManifestState before = opened.state();
  const Saving saving = opened.save(brisker(before.document), before.version, false);
  EXPECT_EQ(saving.outcome, Saving::Outcome::saved);
  std::string wanted = quickstart;
  wanted.replace(wanted.find("quickness: 0.7"), 14, "quickness: 0.9");
  EXPECT_EQ(read_file(file_), wanted);
  EXPECT_EQ(saving.state.text, wanted);
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(opened.save(saving.state.document, saving.state.version, false).outcome,
            Saving::Outcome::unchanged);
  // Nothing else lies beside it.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator{}), 1);
}

TEST_F(OpenedManifest, IsNotWrittenOverWhenItWasChangedElsewhere) {
  ManifestFile opened(file_, process_environment());
  const ManifestState before = opened.state();
  const std::string elsewhere = quickstart + "# a remark\n";
  write_file(file_, elsewhere);
  const ordered_json wanted = brisker(before.document);
  EXPECT_EQ(opened.save(wanted, before.version, false).outcome, Saving::Outcome::elsewhere);
  EXPECT_EQ(read_file(file_), elsewhere);
  // Over it: what is there, and what was wanted.
  const Saving saving = opened.save(wanted, before.version, true);
  EXPECT_EQ(saving.outcome, Saving::Outcome::saved);
  EXPECT_NE(read_file(file_).find("# a remark\n"), std::string::npos);
  EXPECT_NE(read_file(file_).find("quickness: 0.9"), std::string::npos);
}

TEST_F(OpenedManifest, IsNotWrittenWhenCheckWouldRefuseIt) {
  ManifestFile opened(file_, process_environment());
  const ManifestState before = opened.state();
  ordered_json wanted = before.document;
  wanted["stimuli"][0]["adjectives"]["quicknes"] = 0.5;
  EXPECT_THROW(opened.save(wanted, before.version, false), Faults);
  wanted = before.document;
  wanted["stimuli"][0]["id"] = "renamed";  // a sheet names it by the old one
  EXPECT_THROW(opened.save(wanted, before.version, false), Faults);
  EXPECT_EQ(read_file(file_), quickstart);
}

TEST_F(OpenedManifest, IsWrittenThroughALink) {
  const fs::path link = folder_.path() / "link.yaml";
  fs::create_symlink("my.yaml", link);
  ManifestFile opened(link, process_environment());
  const ManifestState before = opened.state();
  opened.save(brisker(before.document), before.version, false);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_NE(read_file(file_).find("quickness: 0.9"), std::string::npos);
}

TEST_F(OpenedManifest, IsRefusedWhenItIsAtFault) {
  write_file(file_, "mien: 1\nstudy: x\n");
  EXPECT_THROW(ManifestFile(file_, process_environment()), Faults);
}

TEST_F(OpenedManifest, BeginsFromATextAndIsMadeWhenSaved) {
  const fs::path file = folder_.path() / "new.yaml";
  ManifestFile opened(file, process_environment(), quickstart);
  EXPECT_FALSE(opened.is_on_disk());
  EXPECT_FALSE(fs::exists(file));
  const ManifestState before = opened.state();
  opened.save(brisker(before.document), before.version, false);
  EXPECT_TRUE(opened.is_on_disk());
  EXPECT_TRUE(check_manifest(file, process_environment()).faults.empty());
}

}  // namespace
}  // namespace mien::pipeline
