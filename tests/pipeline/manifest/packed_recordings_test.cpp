#include "pipeline/manifest/packed_recordings.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class PackedRecordingsList : public testing::Test {
 protected:
  void save(const std::string& text) const {
    write_file(folder.path() / packed_recordings_path, text);
  }
  PackedRecordings list() const { return packed_recordings_in(folder.path()); }

  const test::TemporaryFolder folder;
};

TEST_F(PackedRecordingsList, IsReadAsItWasWritten) {
  EXPECT_TRUE(list().empty());
  const PackedRecordings written{{"captures/a.bvh", "captures (2)/a.bvh"},
                                 {"amass/walk.npz"},
                                 {"clips/walk.bvh"},
                                 {{"../../captures", "captures"}, {"/b/captures", "captures (2)"}}};
  save(to_json(written));
  const PackedRecordings read = list();
  EXPECT_EQ(read.packed, written.packed);
  EXPECT_EQ(read.left_out, written.left_out);
  EXPECT_EQ(read.left_out_files, written.left_out_files);
  EXPECT_EQ(read.folders, written.folders);
}

TEST_F(PackedRecordingsList, SaysWhereFilesOfTheManifestAre) {
  const fs::path study = folder.path();
  const PackedRecordings recordings{
      {"captures (2)/a.bvh"}, {}, {}, {{"../captures", "captures (2)"}}};
  const fs::path place = study / "recordings/captures (2)";
  EXPECT_EQ(packed_place(recordings, study, "../captures"), place);
  EXPECT_EQ(packed_place(recordings, study, "../captures/a.bvh"), place / "a.bvh");
  for (const char* text :
       {"../other/a.bvh", "captures/a.bvh", "a.bvh", "", "../captures/", "../captures/.."})
    EXPECT_TRUE(packed_place(recordings, study, text).empty()) << text;
}

TEST_F(PackedRecordingsList, ThatIsDamagedIsRefused) {
  const char* rest = R"(, "left_out": [], "left_out_files": [], "folders": {}})";
  for (const std::string& packed :
       {std::string("[\"../a.bvh\"]"), std::string("[\"/etc/passwd\"]"), std::string("[3]"),
        std::string("3"), std::string("[\"\"]"), std::string(5000, '[')}) {
    save("{\"packed\": " + packed + rest);
    EXPECT_THROW(list(), Error) << packed.substr(0, 20);
  }
  save(R"({"packed": [], "left_out": [], "left_out_files": [], "folders": {"a": "../b"}})");
  EXPECT_THROW(list(), Error);
  save("");
  EXPECT_THROW(list(), Error);
  save(R"({"packed": [], "left_out": [], "left_out_files": [], "folders": {}})");
  EXPECT_TRUE(list().empty());
}

}  // namespace
}  // namespace mien::pipeline
