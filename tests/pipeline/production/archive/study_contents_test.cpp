#include "pipeline/production/archive/study_contents.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/archive/made_study.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string refusal(const fs::path& study) {
  try {
    contents_of(study);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(StudyContents, AreWhatTheProvenanceTells) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  EXPECT_EQ(contents.study, "tiny");
  EXPECT_EQ(contents.seed, 7u);
  EXPECT_EQ(contents.as_run, "inputs/as-run.yaml");
  ASSERT_NE(contents.find("frames/a"), nullptr);
  EXPECT_GT(contents.find("frames/a")->frames, 5);
  EXPECT_EQ(contents.find("frames/b"), nullptr);
  ASSERT_EQ(contents.inputs.size(), 2u);
  EXPECT_EQ(contents.inputs[0].path, "inputs/m.yaml");
  EXPECT_EQ(contents_of(study / "provenance.json").folder, study.folder());
}

TEST(StudyContents, OfABagAreThoseOfTheStudyInIt) {
  const test::MadeStudy study;
  fs::create_directories(study.beside("bag"));
  fs::rename(study.folder(), study.beside("bag/data"));
  EXPECT_NE(refusal(study.beside("bag")), "");
  write_file(study.beside("bag/bagit.txt"), "");
  EXPECT_EQ(contents_of(study.beside("bag")).folder, study.beside("bag/data"));
}

TEST(StudyContents, AreRefusedWithoutAProvenance) {
  const test::MadeStudy study;
  EXPECT_NE(refusal(study.beside("none")).find("there is no such study"), std::string::npos);
  write_file(study.beside("packed.tar"), "");
  EXPECT_NE(refusal(study.beside("packed.tar")).find("unpack archives"), std::string::npos);
  write_file(study / "provenance.json", R"({"mien": "0.2.0", "study": 5})");
  EXPECT_NE(refusal(study.folder()).find("this is not the provenance of a study"),
            std::string::npos);
  write_file(study / "provenance.json", "[");
  EXPECT_NE(refusal(study.folder()).find("this is not the provenance of a study"),
            std::string::npos);
  fs::remove(study / "provenance.json");
  EXPECT_NE(refusal(study.folder()).find("there is no such file; mien run"), std::string::npos);
}

TEST(StudyContents, LieInTheStudysFolderAndNowhereElse) {
  const std::vector<std::function<void(ordered_json&)>> forgeries = {
      [](ordered_json& record) {
        record["artifacts"]["../a.txt"] = record["artifacts"]["frames/a"];
      },
      [](ordered_json& record) { record["artifacts"]["/etc/x"] = record["artifacts"]["frames/a"]; },
      [](ordered_json& record) { record["inputs"]["inputs/../../x"] = "0"; },
      [](ordered_json& record) { record["manifest"]["as_run"] = "../x.yaml"; },
      [](ordered_json& record) { record["study"] = "a/b"; },
      [](ordered_json& record) { record["study"] = ".."; }};
  for (const auto& forgery : forgeries) {
    const test::MadeStudy study;
    study.forge(forgery);
    EXPECT_NE(refusal(study.folder()).find("do not trust this study"), std::string::npos)
        << refusal(study.folder());
  }
}

}  // namespace
}  // namespace mien::pipeline
