#include "pipeline/production/archive/verify.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/archive/keep.h"
#include "pipeline/production/archive/made_study.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

Verification verification_of(const test::MadeStudy& study) {
  return verify(contents_of(study.folder()), 2, {}, {});
}

/// "changed frames/a/00001.png: different content", a line each.
std::string told(const test::MadeStudy& study) {
  std::string text;
  for (const Finding& finding : verification_of(study).findings) {
    text += std::string(name_of(finding.kind)) + " " + finding.path +
            (finding.what.empty() ? "" : ": " + finding.what) + "\n";
  }
  return text;
}

void flip_a_bit(const fs::path& file) {
  std::string bytes = read_file(file);
  bytes[bytes.size() / 2] ^= 1;
  write_file(file, bytes);
}

TEST(Verify, FindsNothingInAStudyThatIsAsItWasMade) {
  const test::MadeStudy study;
  const Verification found = verification_of(study);
  EXPECT_EQ(told(study), "");
  EXPECT_TRUE(found.is_sound());
  EXPECT_EQ(found.videos, 5);
  EXPECT_GT(found.pictures, 20);
  EXPECT_EQ(found.inputs, 2);
  EXPECT_GT(found.bytes, 100'000u);
  study.forget_receipts();
  EXPECT_EQ(told(study), "");
}

TEST(Verify, TellsWhatIsMissing) {
  const test::MadeStudy study;
  fs::remove(study / "videos/b.mp4");
  fs::remove(study / "inputs/my.recipes.yaml");
  fs::remove_all(study / "frames/d");
  fs::remove(study / "frames/a/00003.png");
  fs::remove(study / "inputs/as-run.yaml");
  const std::string frames =
      std::to_string(contents_of(study.folder()).find("frames/d")->frames) + " frames";
  EXPECT_EQ(told(study), "missing frames/a/00003.png\nmissing frames/d: " + frames +
                             "\nmissing inputs/as-run.yaml: there is no such file\n"
                             "missing inputs/my.recipes.yaml\nmissing videos/b.mp4\n");
  EXPECT_FALSE(verification_of(study).is_sound());
}

TEST(Verify, TellsWhatIsChangedToTheSingleFrame) {
  const test::MadeStudy study;
  flip_a_bit(study / "videos/b.mp4");
  flip_a_bit(study / "metrics/stimuli.csv");
  flip_a_bit(study / "frames/a/00002.png");
  flip_a_bit(study / "inputs/m.yaml");
  write_file(study / "report.html", "<!DOCTYPE html>");
  const auto size = contents_of(study.folder()).find("report.html")->size;
  EXPECT_EQ(told(study),
            "changed frames/a/00002.png: different content\n"
            "changed inputs/m.yaml: different content\n"
            "changed metrics/stimuli.csv: different content\n"
            "changed report.html: 15 bytes instead of " +
                std::to_string(size) + "\nchanged videos/b.mp4: different content\n");
}

TEST(Verify, TellsChangedFramesWithoutReceiptsToo) {
  const test::MadeStudy study;
  study.forget_receipts();
  const int frames = contents_of(study.folder()).find("frames/a")->frames;
  const std::string one = read_file(study / "frames/a/00002.png");
  write_file(study / "frames/a/00002.png", read_file(study / "frames/a/00001.png"));
  EXPECT_EQ(told(study), "changed frames/a: a frame differs\n");
  write_file(study / "frames/a/00002.png", one);
  fs::remove(study / "frames/a/00001.png");
  EXPECT_EQ(told(study), "changed frames/a: " + std::to_string(frames - 1) + " frames instead of " +
                             std::to_string(frames) + "\n");
}

TEST(Verify, TellsWhatNobodyKnows) {
  const test::MadeStudy study;
  write_file(study / "notes.txt", "mine");
  fs::create_directories(study / "videos/old");
  write_file(study / "videos/old/b.mp4", "mine");
  write_file(study / "frames/a/copy.png", "mine");
  fs::create_directories(study / "farm/0001");
  write_file(study / "farm/0001/1-frames.sbatch", "the farm's");
  fs::create_symlink(".", study / "loop");
  EXPECT_EQ(told(study),
            "extra frames/a/copy.png\nextra loop\nextra notes.txt\nextra videos/old/b.mp4\n");
  EXPECT_TRUE(verification_of(study).is_sound());
}

TEST(Verify, TellsWhatStandsInAFilesPlace) {
  const test::MadeStudy study;
  fs::remove(study / "videos/b.mp4");
  ASSERT_EQ(::mkfifo((study / "videos/b.mp4").c_str(), 0600), 0);
  fs::remove(study / "methods.md");
  fs::create_directory(study / "methods.md");
  fs::remove(study / "references.bib");
  fs::create_symlink("references.bib", study / "references.bib");
  fs::remove_all(study / "frames/a");
  write_file(study / "frames/a", "no folder");
  const std::string found = told(study);
  EXPECT_NE(found.find("changed videos/b.mp4: is a pipe, not a file\n"), std::string::npos);
  EXPECT_NE(found.find("changed methods.md: is a folder, not a file\n"), std::string::npos);
  EXPECT_NE(found.find("changed references.bib: cannot be read ("), std::string::npos) << found;
  EXPECT_NE(found.find("changed frames/a: is not a folder of frames\n"), std::string::npos);
}

TEST(Verify, DecodesWhatItsHashDoesNotBetray) {
  const test::MadeStudy study;
  study.forget_receipts();
  const auto cut = [&](const std::string& path) {
    const std::string bytes = read_file(study / path);
    study.forge_artifact(path, bytes.substr(0, bytes.size() - bytes.size() / 3));
  };
  const std::vector<std::string> cut_short = {"clips/a.bvh",          "metrics/codebook.json",
                                              "report.html",          "sheets/a_b.pdf",
                                              "sheets/contact/a.png", "videos/b.mp4"};
  for (const std::string& path : cut_short) cut(path);
  cut("videos/a_with_b.webm");
  study.forge_artifact("metrics/views.csv", "a,b\n1\n");
  study.forge_artifact("methods.md", "\xff\xfe");
  const std::string found = told(study);
  for (const std::string& path : cut_short)
    EXPECT_NE(found.find("changed " + path + ": does not decode: "), std::string::npos)
        << path << "\n"
        << found;
  EXPECT_NE(found.find("changed metrics/views.csv: does not decode: "), std::string::npos);
  EXPECT_NE(found.find("changed methods.md: does not decode: is not UTF-8 text"),
            std::string::npos);
  EXPECT_NE(found.find("changed videos/a_with_b.webm: has "), std::string::npos) << found;
  EXPECT_EQ(std::ranges::count(found, '\n'), 9) << found;
}

TEST(Verify, CountsAVideosFrames) {
  const test::MadeStudy study;
  study.forge_artifact("videos/b.mp4", read_file(study / "videos/c.lossless.mp4"));
  const std::string found = told(study);
  EXPECT_NE(found.find("changed provenance.json: different content\nchanged videos/b.mp4: has "),
            std::string::npos)
      << found;
  EXPECT_NE(found.find(" of its record\n"), std::string::npos) << found;
}

TEST(Verify, KnowsWhatWasRemovedOnPurposeByItsHash) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  ArtifactRecord video = *contents.find("videos/b.mp4");
  ArtifactRecord clip = *contents.find("clips/a.bvh");
  clip.hash = "of another run";
  note_not_kept(study.folder(), {video, clip});
  EXPECT_EQ(told(study), "");  // they are there
  fs::remove(study / video.path);
  fs::remove(study / clip.path);
  EXPECT_EQ(told(study), "missing clips/a.bvh\nnot kept videos/b.mp4\n");
}

TEST(Verify, TellsItsProgressAndStopsWhenAsked) {
  const test::MadeStudy study;
  double last = 0.0;
  verify(contents_of(study.folder()), 2, {}, [&](double share, const std::string& path) {
    EXPECT_GT(share, last);
    EXPECT_FALSE(path.empty());
    last = share;
  });
  EXPECT_NEAR(last, 1.0, 1e-9);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(verify(contents_of(study.folder()), 2, stop.get_token(), {}), Interrupted);
}

}  // namespace
}  // namespace mien::pipeline
