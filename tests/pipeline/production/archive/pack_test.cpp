#include "pipeline/production/archive/pack.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/archive/made_study.h"
#include "pipeline/production/archive/tar_archive.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

std::string packed(const test::MadeStudy& study, const std::string& name) {
  const StudyContents contents = contents_of(study.folder());
  pack(contents, payload_of(contents), {}, study.beside(name), {}, {});
  return read_file(study.beside(name));
}

std::size_t files_beside(const test::MadeStudy& study) {
  const auto files = fs::directory_iterator(study.beside(""));
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(Pack, GivesTheSameBytesEachTime) {
  const test::MadeStudy study, copy;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(copy.folder())) {
    fs::last_write_time(entry, fs::file_time_type::clock::now() - std::chrono::hours(99));
    if (entry.is_regular_file()) fs::permissions(entry, fs::perms::owner_read);
  }
  for (const char* name : {"a.tar", "a.tar.gz", "a.tgz", "a.tar.zst"}) {
    const std::string bytes = packed(study, name);
    EXPECT_GT(bytes.size(), 1000u);
    EXPECT_EQ(bytes, packed(copy, name)) << name;
  }
}

TEST(Pack, TakesAllOfAStudyButTheBookkeeping) {
  const test::MadeStudy study;
  fs::create_directories(study / "farm/0001/log");
  write_file(study / "farm/0001/log/1", "the farm's");
  write_file(study / "notes.txt", "mine");
  std::vector<std::string> paths;
  for (const PayloadFile& file : payload_of(contents_of(study.folder())))
    paths.push_back(file.path);
  EXPECT_TRUE(std::ranges::is_sorted(paths));
  const auto has = [&](const char* path) { return std::ranges::count(paths, path) == 1; };
  for (const char* path :
       {"provenance.json", "frames/a/00000.png", "inputs/as-run.yaml", "notes.txt", "videos/b.mp4"})
    EXPECT_TRUE(has(path)) << path;
  EXPECT_TRUE(std::ranges::none_of(paths, [](const std::string& path) {
    return path.starts_with(".mien") || path.starts_with("farm");
  }));
}

/// As if the stimulus had been renamed: what remains of it may be of a recording that must not be
/// shared.
TEST(Pack, LeavesOutWhatAnotherRunMade) {
  const test::MadeStudy study;
  study.forge([](nlohmann::ordered_json& record) {
    for (const char* path : {"clips/a.bvh", "frames/a", "videos/b.mp4"})
      record["artifacts"].erase(path);
  });
  write_file(study / "frames/a/mine.txt", "mine");
  fs::remove(study / "videos/b.mp4");
  const PackedStudy packed = packed_study(contents_of(study.folder()), {});
  EXPECT_EQ(packed.stale, (std::vector<std::string>{"clips/a.bvh", "frames/a"}));
  const auto has = [&](const char* path) {
    return std::ranges::count(packed.payload, path, &PayloadFile::path) == 1;
  };
  for (const char* path : {"clips/a.bvh", "frames/a/00000.png", "frames/a/00008.png"})
    EXPECT_FALSE(has(path)) << path;
  for (const char* path : {"frames/a/mine.txt", "provenance.json", "inputs/as-run.yaml",
                           "inputs/my.recipes.yaml", "videos/c.webp", "report.html"})
    EXPECT_TRUE(has(path)) << path;
}

TEST(Pack, KnowsWhichNamesABagEncodes) {
  EXPECT_EQ(encoded_paths({{"50 %.csv", 1}, {"a\nb", 1}, {"a\rb", 1}, {"tidy/ü, a.csv", 1}}),
            (std::vector<std::string>{"50 %.csv", "a\nb", "a\rb"}));
}

TEST(Pack, FollowsLinksToWhatBelongsToTheStudy) {
  const test::MadeStudy study, plain;
  fs::rename(study / "frames/a", study.beside("elsewhere"));
  fs::create_directory_symlink(study.beside("elsewhere"), study / "frames/a");
  EXPECT_EQ(packed(study, "a.tar"), packed(plain, "a.tar"));
}

TEST(Pack, RefusesWhatAnArchiveCannotHold) {
  const test::MadeStudy study;
  ASSERT_EQ(::mkfifo((study / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(payload_of(contents_of(study.folder())), Error);
}

TEST(Pack, RefusesNamesThatAreNone) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  for (const char* name : {"a.zip", "a", "a.tar.xz", ".tar.bz2"})
    EXPECT_THROW(refuse_archive(contents, study.beside(name)), Error) << name;
  EXPECT_THROW(refuse_archive(contents, study / "a.tar"), Error);
  EXPECT_THROW(refuse_archive(contents, study / "videos/../a.tar"), Error);
  fs::create_directory(study.beside("b.tar"));
  EXPECT_THROW(refuse_archive(contents, study.beside("b.tar")), Error);
  refuse_archive(contents, study.beside("tiny.tar"));
}

TEST(Pack, LeavesNothingOfAnArchiveThatFails) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  std::vector<PayloadFile> payload = payload_of(contents);
  const std::size_t before = files_beside(study);
  payload.back().size += 1;
  EXPECT_THROW(pack(contents, payload, {}, study.beside("a.tar"), {}, {}), std::runtime_error);
  payload.back().size -= 2;
  EXPECT_THROW(pack(contents, payload, {}, study.beside("a.tar"), {}, {}), std::runtime_error);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(pack(contents, payload, {}, study.beside("a.tar"), stop.get_token(), {}),
               Interrupted);
  EXPECT_THROW(pack(contents, payload, {}, study.beside("none/a.tar"), {}, {}), std::runtime_error);
  EXPECT_EQ(files_beside(study), before);
  write_file(study.beside("a.tar"), "older");
  EXPECT_THROW(pack(contents, payload, {}, study.beside("a.tar"), {}, {}), std::runtime_error);
  EXPECT_EQ(read_file(study.beside("a.tar")), "older");
}

TEST(Bag, TellsWhatItHoldsWithoutADate) {
  StudyContents contents;
  contents.study = "tiny";
  contents.program = "0.2.0";
  contents.command = "mien run a\nb.yaml";
  EXPECT_EQ(bag_info_text(contents, {{"a", 5}, {"b", 6}}, {}),
            "Bag-Software-Agent: mien 0.2.0\n"
            "External-Description: Human motion stimuli, made by: mien run a b.yaml\n"
            "External-Identifier: tiny\n"
            "Payload-Oxum: 11.2\n");
  const BagInfo info{"University\nof Somewhere", "A. Walker", "walker@example.org", "Twelve walks",
                     "CC-BY-4.0"};
  EXPECT_EQ(bag_info_text(contents, {}, info),
            "Bag-Software-Agent: mien 0.2.0\n"
            "Contact-Email: walker@example.org\n"
            "Contact-Name: A. Walker\n"
            "External-Description: Twelve walks\n"
            "External-Identifier: tiny\n"
            "License: CC-BY-4.0\n"
            "Payload-Oxum: 0.0\n"
            "Source-Organization: University of Somewhere\n");
  EXPECT_EQ(bag_manifest_line("0a", "data/50 %\r\n.csv"), "0a  data/50 %25%0D%0A.csv\n");
}

}  // namespace
}  // namespace mien::pipeline
