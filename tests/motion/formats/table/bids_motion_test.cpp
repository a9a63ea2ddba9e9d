#include "motion/formats/table/bids_motion.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/gzip_text.h"
#include "motion/refusal.h"
#include "motion/text/file_contents.h"
#include "motion/text/result_file.h"
#include "pipeline/temporary_folder.h"

#include "real_data.h"

namespace mien::motion {
namespace {

using mien::test::refusal_of;

const std::string channels =
    "name\tcomponent\ttype\ttracked_point\tunits\na_x\tx\tPOS\ta\tmm\na_y\ty\tPOS\ta\tmm\n"
    "a_q\tquat_x\tORNT\ta\tn/a\na_z\tz\tPOS\ta\tmm\n#b_x\tx\tPOS\tb\tm\nb_y\ty\tPOS\tb\tm\n"
    "b_z\tz\tPOS\tb\tm\nlat\tn/a\tLATENCY\tn/a\ts\n";
const std::string motion =
    "1\t2\t9\t3\t0.004\t0.005\t0.006\t0.0\nn/a\tn/a\t9\tn/a\t1\t2\t3\t0.01\n";
const std::string sidecar = R"({"SamplingFrequency": 100, "TaskName": "walk"})";

PointRecording parse(const std::string& motion_text, const std::string& channels_text,
                     const std::string& json, const ReadOptions& options = {}) {
  return parse_bids_motion({motion_text, "sub-07_task-walk_tracksys-omc_motion.tsv", channels_text,
                            "channels.tsv", json, "motion.json"},
                           options);
}

std::string refusal(const std::string& motion_text, const std::string& channels_text,
                    const std::string& json) {
  return refusal_of([&] { parse(motion_text, channels_text, json); });
}

void expect_bids_words(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "\"" << words << "\" is not in: " << text;
}

std::string with(std::string text, const std::string& word, const std::string& other) {
  return text.replace(text.find(word), word.size(), other);
}

TEST(BidsMotion, PositionsAreFoundByTheirChannels) {
  const PointRecording recording = parse(motion, channels, sidecar);
  EXPECT_EQ(recording.points, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(recording.frames_per_second, 100.0);
  EXPECT_EQ(recording.unit, "mm");
  EXPECT_EQ(recording.metres_per_unit, 0.001);
  EXPECT_EQ(recording.subjects, std::vector<std::string>{"sub-07"});
  EXPECT_EQ(recording.format, "bids");
  ASSERT_EQ(recording.frame_count(), 2);
  EXPECT_EQ(recording.positions[0], Vec3(1, 2, 3));
  EXPECT_LT((recording.positions[1] - Vec3(4, 5, 6)).norm(), 1e-12);
  EXPECT_FALSE(recording.seen[2]);
  ASSERT_EQ(recording.notes.size(), 1u);
  expect_bids_words(recording.notes[0], "a_q, lat");
}

TEST(BidsMotion, TheSidecarTellsRateAndMissingValues) {
  const std::string json =
      R"({"SamplingFrequency": 480, "SamplingFrequencyEffective": 480.5, "MissingValues": "-999"})";
  const PointRecording recording = parse(with(motion, "0.004", "-999"), channels, json);
  EXPECT_EQ(recording.frames_per_second, 480.5);
  EXPECT_FALSE(recording.seen[1]);
  EXPECT_EQ(recording.notes.size(), 3u);
  expect_bids_words(refusal(motion, channels, "{}"), "fps:");
  expect_bids_words(refusal(motion, channels, R"({"SamplingFrequency": "n/a"})"), "fps:");
  expect_bids_words(refusal(motion, channels, "{\n\"SamplingFrequency\": 1x}"), "motion.json:2:");
  expect_bids_words(refusal(motion, channels, "[1]"), "is not a BIDS sidecar");
}

TEST(BidsMotion, FilesThatDoNotFitAreRefused) {
  expect_bids_words(refusal(motion + "1\t2\t3\t4\t5\t6\t7\t8\t9\n", channels, sidecar),
                    ":3:17: the row has");
  expect_bids_words(refusal("1\t2\n", channels, sidecar), "2 columns, but there are 8 channels");
  expect_bids_words(refusal(motion, with(channels, "units", "unit"), sidecar),
                    "no column \"units\"");
  expect_bids_words(refusal(motion, with(channels, "a\tmm", "a\tparsecs"), sidecar),
                    "\"parsecs\" is not a unit");
  expect_bids_words(refusal(motion, with(channels, "a\tmm", "a\tm"), sidecar),
                    "in different units");
  expect_bids_words(refusal(motion, with(channels, "a_y\ty", "a_y\tx"), sidecar),
                    "two channels of one");
  expect_bids_words(
      refusal(motion, "name\tcomponent\ttype\ttracked_point\tunits\nq\tx\tORNT\ta\trad\n", sidecar),
      "POS");
  expect_bids_words(refusal("", channels, sidecar), "there are no frames");
  EXPECT_EQ(
      parse("a_x\ta_y\ta_q\ta_z\tb_x\tb_y\tb_z\tlat\n" + motion, channels, sidecar).frame_count(),
      2);
}

/// A folder of its own for the files of a test.
std::filesystem::path new_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("mien_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "sub-07" / "motion");
  return folder;
}

TEST(BidsMotion, CompanionsAreFoundByName) {
  const std::filesystem::path root = new_folder("bids_companions");
  const std::filesystem::path folder = root / "sub-07" / "motion";
  const std::string prefix = "sub-07_task-walk_tracksys-omc_";
  const std::filesystem::path file = folder / (prefix + "motion.tsv");
  write_result(file, motion);
  expect_bids_words(refusal_of([&] { read_bids_motion(file); }), "has no channels file");
  write_result(folder / (prefix + "channels.tsv"), channels);
  expect_bids_words(refusal_of([&] { read_bids_motion(file); }), "fps:");
  write_result(root / "task-walk_motion.json", sidecar);
  EXPECT_EQ(read_bids_motion(file).frames_per_second, 100.0);
  write_result(folder / (prefix + "motion.json"), with(sidecar, "100", "50"));
  EXPECT_EQ(read_bids_motion(file).frames_per_second, 50.0);
  EXPECT_TRUE(is_bids_motion(file));
  EXPECT_FALSE(is_bids_motion(folder / "walk.tsv"));
  std::filesystem::remove_all(root);
}

TEST(BidsMotion, RealChannelsAndSidecarAreRead) {
  const auto data = mien::test::real_data();
  if (!data || !std::filesystem::exists(*data / "recordings" / "bids"))
    GTEST_SKIP() << "no real recordings here: set MIEN_DATA to the folder that has them";
  const std::filesystem::path bids = *data / "recordings" / "bids";
  const PointRecording recording =
      parse("0.1\t0.2\t0.3\t1.5\t1.25\t-0.5\t1\t0\n0.1\t0.2\t0.3\tn/a\tn/a\tn/a\t0\t0.002\n",
            read_contents(bids / "channels.tsv"), read_contents(bids / "motion.json"));
  EXPECT_EQ(recording.points, std::vector<std::string>{"Rigid1"});
  EXPECT_EQ(recording.unit, "m");
  EXPECT_NEAR(recording.frames_per_second, 480.1188586, 1e-9);
  EXPECT_EQ(recording.positions[0], Vec3(1.5, 1.25, -0.5));
  EXPECT_FALSE(recording.seen[1]);
}

TEST(BidsMotion, WhatIsWrittenReadsBack) {
  PointRecording recording = parse(motion, channels, sidecar);
  recording.points = {"#1 \"a\"\tb", "LASI"};
  recording.frames_per_second = 59.94;
  BidsLabels labels{"p/../07", "", "walk fast", "Vicon"};
  const auto files = to_bids_motion(recording, labels);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].first, "sub-p07_task-walkfast_tracksys-Vicon_motion.tsv");
  EXPECT_EQ(files[1].first, "sub-p07_task-walkfast_tracksys-Vicon_channels.tsv");
  EXPECT_EQ(files[2].first, "sub-p07_task-walkfast_tracksys-Vicon_motion.json");
  for (const char* const required : {"SamplingFrequency", "TaskName", "TrackingSystemName"})
    expect_bids_words(files[2].second, required);
  const std::filesystem::path root = new_folder("bids_written");
  for (const auto& [name, text] : files) write_result(root / name, text);
  const PointRecording again = read_bids_motion(root / files[0].first);
  EXPECT_EQ(again.points, (std::vector<std::string>{"#1  a  b", "LASI"}));
  EXPECT_EQ(again.seen, recording.seen);
  EXPECT_EQ(again.frames_per_second, 59.94);
  EXPECT_EQ(again.unit, "m");
  for (std::size_t i = 0; i < again.positions.size(); ++i)
    EXPECT_LT((again.positions[i] - 0.001 * recording.positions[i]).norm(), 1e-6);
  std::filesystem::remove_all(root);
}

TEST(BidsMotion, DamagedFilesAreReadOrRefused) {
  std::mt19937 random(38);
  const auto read_anything = [](const std::string& m, const std::string& c, const std::string& j) {
    try {
      const PointRecording recording = parse(m, c, j);
      ASSERT_EQ(recording.positions.size(), recording.seen.size());
      ASSERT_GT(recording.frame_count(), 0);
    } catch (const Error&) {
    }
  };
  for (std::size_t i = 0; i < channels.size(); ++i) {
    read_anything(motion.substr(0, i), channels, sidecar);
    read_anything(motion, channels.substr(0, i), sidecar);
    read_anything(motion, channels, sidecar.substr(0, i));
  }
  for (int i = 0; i < 200; ++i) {
    std::string m = motion;
    std::string c = channels;
    std::string j = sidecar;
    for (std::string* const text : {&m, &c, &j})
      (*text)[random() % text->size()] = "\t\n\"xyz19.-e{}[,"[random() % 14];
    read_anything(m, c, j);
  }
}

TEST(BidsMotion, FindsCompressedChannelsAndSaysWhichFileIsMissing) {
  const test::TemporaryFolder folder;
  const auto file = [&](const std::string& name) { return folder.path() / ("sub-07_" + name); };
  std::ofstream(file("motion.tsv")) << motion;
  std::ofstream(file("motion.json")) << sidecar;
  const std::string missing = refusal_of([&] { read_bids_motion(file("motion.tsv")); });
  expect_bids_words(missing, "has no channels file \"sub-07_channels.tsv\" beside it; put it");
  std::ofstream(file("channels.tsv.gz"), std::ios::binary) << test::gzipped(channels);
  EXPECT_EQ(read_bids_motion(file("motion.tsv")).positions,
            parse(motion, channels, sidecar).positions);
}

}  // namespace
}  // namespace mien::motion
