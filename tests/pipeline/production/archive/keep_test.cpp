#include "pipeline/production/archive/keep.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/archive/made_study.h"
#include "pipeline/production/archive/verify.h"
#include "pipeline/production/run/run.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

const std::vector<ArtifactKind> videos_and_sheets = {ArtifactKind::videos, ArtifactKind::sheets};

TEST(Keep, RemovesAllOtherKindsAndNothingElse) {
  const test::MadeStudy study;
  write_file(study / "clips/mine.bvh", "mine");
  const Cleaning cleaning = remove_all_but(study.folder(), videos_and_sheets);
  EXPECT_TRUE(cleaning.changed.empty());
  EXPECT_GT(cleaning.bytes, 10'000u);
  for (const char* gone : {"frames", "clips/a.bvh", "metrics"})
    EXPECT_FALSE(fs::exists(study / gone)) << gone;
  for (const char* there :
       {"clips/mine.bvh", "videos/b.mp4", "sheets/a_b.pdf", "sheets/contact/a.png", "report.html",
        "methods.md", "references.bib", "provenance.json", "inputs/m.yaml", "inputs/as-run.yaml"})
    EXPECT_TRUE(fs::exists(study / there)) << there;
  const Verification found = verify(contents_of(study.folder()), 1, {}, {});
  EXPECT_TRUE(found.is_sound());
  EXPECT_EQ(found.count(Finding::Kind::extra), 1);
  EXPECT_EQ(found.count(Finding::Kind::not_kept), static_cast<int>(cleaning.removed.size()));
}

TEST(Keep, OnlyLooksWhenAsked) {
  const test::MadeStudy study;
  const Cleaning planned = all_but(study.folder(), videos_and_sheets);
  EXPECT_TRUE(fs::exists(study / "frames/a/00000.png"));
  EXPECT_FALSE(fs::exists(study / not_kept_path));
  const Cleaning done = remove_all_but(study.folder(), videos_and_sheets);
  EXPECT_EQ(planned.bytes, done.bytes);
  EXPECT_EQ(planned.removed.size(), done.removed.size());
  EXPECT_TRUE(all_but(study.folder(), videos_and_sheets).removed.empty());
}

TEST(Keep, LeavesWhatWasChanged) {
  const test::MadeStudy study;
  write_file(study / "clips/a.bvh", "cut by hand");
  write_file(study / "frames/a/00001.png", "retouched");
  const Cleaning cleaning = remove_all_but(study.folder(), videos_and_sheets);
  ASSERT_EQ(cleaning.changed.size(), 2u);
  EXPECT_EQ(cleaning.changed[0].path, "clips/a.bvh");
  EXPECT_EQ(cleaning.changed[1].path, "frames/a");
  EXPECT_TRUE(fs::exists(study / "frames/a/00000.png"));
}

TEST(Keep, NotesRemainWhenMoreIsRemoved) {
  const test::MadeStudy study;
  remove_all_but(study.folder(), {ArtifactKind::videos, ArtifactKind::sheets, ArtifactKind::metrics,
                                  ArtifactKind::clips});
  const std::size_t frames = not_kept_in(study.folder()).size();
  EXPECT_EQ(frames, 2u);
  remove_all_but(study.folder(), videos_and_sheets);
  EXPECT_GT(not_kept_in(study.folder()).size(), frames);
  EXPECT_TRUE(verify(contents_of(study.folder()), 1, {}, {}).is_sound());
}

TEST(Keep, ARunMakesItAgainToTheLastByte) {
  const test::MadeStudy study;
  const std::string before = read_file(study / "provenance.json");
  remove_all_but(study.folder(), videos_and_sheets);
  Production production(
      load_manifest(study / "provenance.json", [](const std::string&) { return std::nullopt; }),
      {});
  EXPECT_TRUE(run(production, study.folder(), 2, {}, {}).is_complete());
  EXPECT_EQ(read_file(study / "provenance.json"), before);
  const Verification found = verify(contents_of(study.folder()), 1, {}, {});
  EXPECT_TRUE(found.findings.empty());
}

TEST(Keep, CountsLinksOfTheReportThatLeadNowhereThen) {
  const test::MadeStudy study;
  write_file(study / "report.html",
             R"(<a href="clips/a.bvh">a</a><video src="videos/b.mp4" poster="frames/a/00001.png">)"
             R"(<img src="frames/ab/00001.png"><a href="https://example.org">)");
  EXPECT_EQ(dead_links(study.folder(), all_but(study.folder(), videos_and_sheets)), 2);
  EXPECT_EQ(dead_links(study.folder(), {}), 0);
  fs::remove(study / "report.html");
  EXPECT_EQ(dead_links(study.folder(), all_but(study.folder(), videos_and_sheets)), 0);
}

TEST(Keep, NeedsReceipts) {
  const test::MadeStudy study;
  study.forget_receipts();
  EXPECT_THROW(all_but(study.folder(), videos_and_sheets), Error);
  EXPECT_THROW(all_but(study.beside("none"), videos_and_sheets), Error);
}

TEST(NotKept, IsRefusedWhenItIsDamaged) {
  const test::MadeStudy study;
  write_file(study / not_kept_path, "{\"not_kept\": 5}");
  EXPECT_THROW(not_kept_in(study.folder()), Error);
}

}  // namespace
}  // namespace mien::pipeline
