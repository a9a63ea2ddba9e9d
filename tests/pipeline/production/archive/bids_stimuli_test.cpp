#include "pipeline/production/archive/bids_stimuli.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/archive/made_study.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

std::vector<std::vector<std::string>> cells_of(const std::string& tsv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(tsv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line + "\t");
    for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  return rows;
}

const PayloadFile& file_at(const BidsStimuli& stimuli, const std::string& path) {
  return *std::ranges::find(stimuli.files, path, &PayloadFile::path);
}

TEST(BidsStimuli, AreNamedAndDescribedAsTheProposalSays) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  const BidsStimuli stimuli = bids_stimuli(contents, payload_of(contents), "CC0-1.0");
  EXPECT_TRUE(std::ranges::is_sorted(stimuli.files, {}, &PayloadFile::path));
  const std::regex name("stimuli/(stimuli\\.(tsv|json)|stim-[0-9A-Za-z]+_video\\.(mp4|webm|json))");
  std::set<std::string> media;
  for (const PayloadFile& file : stimuli.files) {
    EXPECT_TRUE(std::regex_match(file.path, name)) << file.path;
    if (file.text.empty()) media.insert(fs::path(file.path).filename().string());
  }
  EXPECT_TRUE(media.contains("stim-b_video.mp4"));
  EXPECT_TRUE(media.contains("stim-c_video.mp4"));
  EXPECT_EQ(read_file(file_at(stimuli, "stimuli/stim-b_video.mp4").from),
            read_file(study / "videos/b.mp4"));
  // Animated pictures have no place in the proposal.
  EXPECT_EQ(stimuli.omitted, (std::vector<std::string>{"videos/a.gif", "videos/c.webp"}));

  const auto rows = cells_of(file_at(stimuli, "stimuli/stimuli.tsv").text);
  const auto meanings = nlohmann::json::parse(file_at(stimuli, "stimuli/stimuli.json").text);
  ASSERT_GE(rows.size(), 3u);
  EXPECT_EQ(rows[0][0], "stimulus_id");
  EXPECT_EQ(rows[0][1], "type");
  for (const std::string& column : rows[0])
    EXPECT_TRUE(meanings.contains(column) && meanings[column].contains("Description")) << column;
  std::set<std::string> named;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size());
    EXPECT_TRUE(rows[i][0].starts_with("stim-"));
    EXPECT_EQ(rows[i][1], "video");
    EXPECT_EQ(rows[i][2], "CC0-1.0");
    for (const std::string& cell : rows[i]) EXPECT_NE(cell, "") << "not known is n/a";
    std::istringstream files(rows[i][4]);
    for (std::string file; std::getline(files, file, ',');) named.insert(file);
  }
  EXPECT_EQ(named, media);
}

TEST(BidsStimuli, HaveLabelsThatDiffer) {
  const test::MadeStudy study;
  StudyContents contents = contents_of(study.folder());
  const std::vector<PayloadFile> payload = {{"videos/AB2.mp4", 1}, {"videos/a-b.mp4", 2},
                                            {"videos/aB.mp4", 3},  {"videos/a_b.mp4", 4},
                                            {"videos/ab.mp4", 5},  {"videos/ä.mp4", 6}};
  for (const PayloadFile& file : payload) contents.artifacts.push_back({file.path, "", file.size});
  std::ranges::sort(contents.artifacts, {}, &ArtifactRecord::path);
  const BidsStimuli stimuli = bids_stimuli(contents, payload, "");
  std::map<std::string, std::uint64_t> sizes;
  for (const PayloadFile& file : stimuli.files)
    if (file.text.empty()) sizes[file.path] = file.size;
  // Names that differ only in case are the same to some file systems.
  EXPECT_EQ(sizes, (std::map<std::string, std::uint64_t>{{"stimuli/stim-AB2_video.mp4", 1},
                                                         {"stimuli/stim-ab3_video.mp4", 2},
                                                         {"stimuli/stim-aB_video.mp4", 3},
                                                         {"stimuli/stim-ab4_video.mp4", 4},
                                                         {"stimuli/stim-ab5_video.mp4", 5},
                                                         {"stimuli/stim-stimulus_video.mp4", 6}}));
  EXPECT_EQ(cells_of(file_at(stimuli, "stimuli/stimuli.tsv").text)[1][2], "n/a");
}

TEST(BidsStimuli, AreThoseOfTheStudyAlone) {
  const test::MadeStudy study;
  study.forge(
      [](nlohmann::ordered_json& record) { record["artifacts"].erase("videos/c.lossless.mp4"); });
  fs::copy_file(study / "videos/b.mp4", study / "videos/mine.mp4");
  study.forget_receipts();
  const StudyContents contents = contents_of(study.folder());
  const BidsStimuli stimuli = bids_stimuli(contents, payload_of(contents), "");
  const auto has = [&](const char* path) {
    return std::ranges::count(stimuli.files, path, &PayloadFile::path) == 1;
  };
  EXPECT_TRUE(has("stimuli/stim-b_video.mp4"));
  EXPECT_FALSE(has("stimuli/stim-c_video.mp4"));
  EXPECT_FALSE(has("stimuli/stim-mine_video.mp4"));
}

TEST(BidsStimuli, AreCalledAudiovisualWhereTheyHaveSound) {
  const test::MadeStudy study;
  std::string record = read_file(study / "metrics/films/b.json");
  auto json = nlohmann::ordered_json::parse(record);
  json["videos"][0]["sound"] = {{"codec", "aac"}, {"rate", 48000},  {"channels", 1},
                                {"frames", 10},   {"hash", "0123"}, {"correlation", 1.0}};
  study.forge_artifact("metrics/films/b.json", json.dump());
  const StudyContents contents = contents_of(study.folder());
  const BidsStimuli stimuli = bids_stimuli(contents, payload_of(contents), "");
  EXPECT_TRUE(
      std::ranges::count(stimuli.files, "stimuli/stim-b_audiovideo.mp4", &PayloadFile::path) == 1);
}

TEST(BidsStimuli, OfDamagedRecordsAreRefused) {
  const test::MadeStudy study;
  write_file(study / "metrics/films/b.json", "{");
  const StudyContents contents = contents_of(study.folder());
  EXPECT_THROW(bids_stimuli(contents, payload_of(contents), ""), Error);
}

}  // namespace
}  // namespace mien::pipeline
