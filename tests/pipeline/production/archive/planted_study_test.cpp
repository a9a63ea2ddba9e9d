#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/planted_names.h"
#include "pipeline/production/archive/keep.h"
#include "pipeline/production/archive/made_study.h"
#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Whatever a study's records name lies in its folder, or they are refused.
TEST(PlantedStudy, NamesNothingElsewhereInAnyFieldOfItsProvenance) {
  const test::MadeStudy study;
  write_file(study.beside("planted"), "mine");
  const auto before = test::surroundings(study.folder().parent_path(), study.folder());
  json record = json::parse(read_file(study / "provenance.json"));
  for (const char* unread : {"stimuli", "overlays", "libraries", "equalize", "code"})
    record.erase(unread);
  const fs::path root = study.folder().lexically_normal();
  int read = 0, refused = 0;
  const auto names = test::planted_names(study.beside("planted"));
  test::each_planted(record, names, [&](const json& planted, const std::string& at) {
    write_file(study / "provenance.json",
               planted.dump(-1, ' ', false, json::error_handler_t::replace));
    try {
      const StudyContents contents = contents_of(study.folder());
      ++read;
      std::vector<std::string> paths = {contents.study, contents.as_run};
      for (const ArtifactRecord& one : contents.artifacts) paths.push_back(one.path);
      for (const ArtifactRecord& one : contents.inputs) paths.push_back(one.path);
      for (const std::string& path : paths) {
        const fs::path place = (root / path).lexically_normal();
        EXPECT_TRUE(place.string().starts_with(root.string() + "/")) << at << ": " << path;
        EXPECT_EQ(path.find('\0'), std::string::npos) << at;
      }
    } catch (const Error&) {
      ++refused;
    }
  });
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 20);
  EXPECT_EQ(test::surroundings(study.folder().parent_path(), study.folder()), before);
}

TEST(PlantedStudy, NamesNothingElsewhereInItsNoteOfWhatWasRemoved) {
  const test::MadeStudy study;
  for (const std::string& name : test::planted_names("/planted")) {
    const json note = {{"not_kept", {{name, {{"hash", "0"}, {"size", 1}}}}}};
    write_file(study / not_kept_path, note.dump());
    EXPECT_THROW(not_kept_in(study.folder()), Error) << name;
  }
}

TEST(PlantedStudy, IsMadeAgainOfItsOwnInputsAlone) {
  const test::MadeStudy study;
  write_file(study.beside("secret"), "a secret: [\n");
  for (const char* at : {"as_run", "copy"}) {
    for (const std::string& name :
         {study.beside("secret").string(), std::string("inputs/../../secret")}) {
      const test::MadeStudy forged;
      forged.forge([&](nlohmann::ordered_json& record) { record["manifest"][at] = name; });
      try {
        check_manifest(forged / "provenance.json", process_environment());
        ADD_FAILURE() << name;
      } catch (const Error& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find("provenance.json: the path \""), std::string::npos) << said;
        EXPECT_EQ(said.find("a secret"), std::string::npos) << said;
      }
    }
  }
}

/// A receipt whose frames lie elsewhere, with their true hashes: cleaning removed them.
TEST(PlantedStudy, IsCleanedOfItsOwnFilesAlone) {
  const test::MadeStudy study;
  write_file(study.beside("thesis.tex"), "mine");
  std::optional<Receipt> receipt = read_receipt(study.folder(), "frames/a");
  ASSERT_TRUE(receipt);
  receipt->frames[0] = {"../../../thesis.tex", hash_of_file(study.beside("thesis.tex")), 4};
  write_file(receipt_path(study.folder(), "frames/a"), to_json(*receipt));
  remove_all_but(study.folder(), {});
  EXPECT_TRUE(fs::exists(study.beside("thesis.tex")));
  EXPECT_TRUE(fs::exists(study / "frames/a/00001.png")) << "nobody knows whose it is";
}

TEST(PlantedStudy, IsNotCleanedThroughALinkThatLeadsOut) {
  const test::MadeStudy study;
  fs::rename(study / "frames", study.beside("elsewhere"));
  fs::create_directory_symlink(study.beside("elsewhere"), study / "frames");
  const Cleaning cleaning = remove_all_but(study.folder(), {});
  EXPECT_TRUE(fs::exists(study.beside("elsewhere/a/00001.png")));
  EXPECT_FALSE(cleaning.removed.empty());
  EXPECT_FALSE(cleaning.changed.empty());
}

TEST(PlantedZip, IsRefusedWithAnyEntryThatLeadsOut) {
  for (const std::string name : {"../x", "/x", "a/../../b", "a/..", "a\\..\\..\\b", "C:/x", "C:\\x",
                                 "a//b", "./x", "a\nb", "con", "x/nul.txt"}) {
    EXPECT_THROW(unzipped(zip_of({{"a.txt", "1"}, {name, "x"}}), "some.zip"), Error) << name;
  }
}

}  // namespace
}  // namespace mien::pipeline
