#include "pipeline/study/studio/manifest_file.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/study/studio/studio_fixture.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

const std::string quickstart =
    read_file(fs::path(MIEN_SOURCE_DIR) / "manifests" / "quickstart.yaml");

class OpenedManifest : public testing::Test {
 protected:
  OpenedManifest() { write_file(file_, quickstart); }

  /// Saves a text with a change, made from a state of the file.
  static SaveResult save(ManifestFile& opened, const ManifestState& from) {
    ordered_json document = from.document;
    document["stimuli"][0]["adjectives"]["quickness"] = 0.9;
    return opened.save(brisker(from.text), document, from.version);
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "my.yaml";
};

TEST_F(OpenedManifest, IsSavedWithTheChangeAndNothingElse) {
  ManifestFile opened(file_, process_environment());
  fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write);
  const ManifestState before = opened.state();
  const SaveResult saving = save(opened, before);
  EXPECT_EQ(saving.outcome, SaveResult::Outcome::saved);
  const std::string wanted = brisker(quickstart);
  EXPECT_EQ(read_file(file_), wanted);
  EXPECT_EQ(saving.state.text, wanted);
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(opened.save(wanted, saving.state.document, saving.state.version).outcome,
            SaveResult::Outcome::unchanged);
  // Nothing else lies beside it.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator{}), 1);
}

TEST_F(OpenedManifest, IsNotWrittenOverWhenItWasChangedElsewhere) {
  ManifestFile opened(file_, process_environment());
  const ManifestState before = opened.state();
  const std::string elsewhere = quickstart + "# a remark\n";
  write_file(file_, elsewhere);
  const SaveResult refused = save(opened, before);
  EXPECT_EQ(refused.outcome, SaveResult::Outcome::elsewhere);
  EXPECT_EQ(refused.state.text, elsewhere);
  EXPECT_EQ(read_file(file_), elsewhere);
  // Into what is there.
  EXPECT_EQ(save(opened, refused.state).outcome, SaveResult::Outcome::saved);
  EXPECT_EQ(read_file(file_), brisker(elsewhere));
}

TEST_F(OpenedManifest, IsWrittenAnewWhereItHasGone) {
  ManifestFile opened(file_, process_environment());
  fs::remove(file_);
  const SaveResult refused = save(opened, opened.state());
  EXPECT_EQ(refused.outcome, SaveResult::Outcome::elsewhere);
  EXPECT_FALSE(fs::exists(file_));
  EXPECT_EQ(save(opened, refused.state).outcome, SaveResult::Outcome::saved);
  EXPECT_EQ(read_file(file_), brisker(quickstart));
}

TEST_F(OpenedManifest, IsNotWrittenWhenCheckWouldRefuseItOrItSaysSomethingElse) {
  ManifestFile opened(file_, process_environment());
  const ManifestState before = opened.state();
  const auto write = [&](const std::string& from, const std::string& to, const char* at) {
    std::string text = quickstart;
    text.replace(text.find(from), from.size(), to);
    ordered_json document = before.document;
    if (*at != '\0') document[ordered_json::json_pointer(at)] = to;
    return opened.save(text, document, before.version);
  };
  EXPECT_THROW(write("study: quickstart", "study: other", ""), Error);
  EXPECT_THROW(write("study: quickstart", "study: [", ""), Faults);
  // A sheet names it by the old one.
  EXPECT_THROW(write("target-1", "renamed", "/stimuli/0/id"), Faults);
  EXPECT_EQ(read_file(file_), quickstart);
}

TEST_F(OpenedManifest, IsWrittenThroughALink) {
  const fs::path link = folder_.path() / "link.yaml";
  fs::create_symlink("my.yaml", link);
  ManifestFile opened(link, process_environment());
  const ManifestState before = opened.state();
  save(opened, before);
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
  save(opened, before);
  EXPECT_TRUE(opened.is_on_disk());
  EXPECT_TRUE(check_manifest(file, process_environment()).faults.empty());
}

}  // namespace
}  // namespace mien::pipeline
