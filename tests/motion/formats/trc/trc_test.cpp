#include "motion/formats/trc/trc.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "motion/text/file_contents.h"
#include "motion/text/result_file.h"

using mien::test::refusal_of;

namespace mien::motion {
namespace {

const std::string head =
    "PathFileType\t4\t(X/Y/Z)\twalk.trc\n"
    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\t"
    "OrigNumFrames\n"
    "100\t100\t3\t2\tmm\t100\t1\t3\n"
    "Frame#\tTime\tLASI\t\t\tRASI\t\t\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
    "\n";
const std::string rows =
    "1\t0.00\t1\t2\t3\t4.5\t-5\t6e1\n"
    "2\t0.01\t1.5\t2\t3\t4\t5\t6\n"
    "3\t0.02\t+2\t2\t3\t4\t5\t6\n";

std::string with(std::string text, const std::string& word, const std::string& other) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) {
    ADD_FAILURE() << "the text has no " << word;
    return text;
  }
  return text.replace(at, word.size(), other);
}

PointRecording parsed(const std::string& text) { return parse_trc(text, "some/walk.trc"); }

bool has_note(const PointRecording& recording, const std::string& words) {
  for (const std::string& note : recording.notes) {
    if (note.find(words) != std::string::npos) return true;
  }
  return false;
}

std::string all_notes(const PointRecording& recording) {
  std::string all;
  for (const std::string& note : recording.notes) all += note + "\n";
  return all;
}

/// Rows of both points at these times, numbered as written.
std::string rows_at(const std::vector<std::pair<int, std::string>>& times) {
  std::string text;
  for (const auto& [frame, time] : times) {
    text +=
        std::to_string(frame) + "\t" + time + "\t" + std::to_string(frame) + "\t2\t3\t4\t5\t6\n";
  }
  return text;
}

void expect_refusal(const std::string& text, const std::string& words) {
  const std::string said = refusal_of([&] { parse_trc(text, "walk.trc"); });
  EXPECT_TRUE(said.starts_with("walk.trc:")) << said;
  EXPECT_NE(said.find(words), std::string::npos) << said << "\nlacks: " << words;
  EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
}

TEST(Trc, IsReadAsItStands) {
  const PointRecording recording = parsed(head + rows);
  EXPECT_EQ(recording.name, "walk");
  EXPECT_EQ(recording.format, "trc");
  EXPECT_EQ(recording.points, (std::vector<std::string>{"LASI", "RASI"}));
  EXPECT_EQ(recording.frames_per_second, 100.0);
  EXPECT_EQ(recording.unit, "mm");
  EXPECT_EQ(recording.metres_per_unit, 0.001);
  ASSERT_EQ(recording.frame_count(), 3);
  EXPECT_EQ(recording.positions[0], Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(recording.positions[1], Vec3(4.5, -5.0, 60.0));
  EXPECT_EQ(recording.positions[4], Vec3(2.0, 2.0, 3.0));
  EXPECT_EQ(all_notes(recording), "");
}

TEST(Trc, LinesMayEndInEveryWay) {
  for (const std::string& end : {std::string("\r\n"), std::string("\r")}) {
    std::string text;
    for (const char c : head + rows) text += c == '\n' ? end : std::string(1, c);
    const PointRecording recording = parsed(text);
    EXPECT_EQ(recording.frame_count(), 3);
    EXPECT_EQ(recording.positions[5], Vec3(4.0, 5.0, 6.0));
  }
  EXPECT_EQ(parsed("\xEF\xBB\xBF" + head + rows.substr(0, rows.size() - 1)).frame_count(), 3);
}

TEST(Trc, HeadersDifferByProgram) {
  // Fields padded and separated twice; older files have fewer.
  EXPECT_EQ(
      parsed(with(head, "100\t100\t3\t2\tmm", " 100.0\t\t  100\t\t 3\t\t 2\t\t mm") + rows).unit,
      "mm");
  const std::string older =
      with(with(head, "\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames", ""), "\tmm\t100\t1\t3",
           "\tm");
  EXPECT_EQ(parsed(older + rows).metres_per_unit, 1.0);
  // Values that are not there keep the others at their places.
  EXPECT_EQ(parsed(with(head, "100\t100\t3\t2\tmm", "100\t\t3\t2\tm") + rows).metres_per_unit, 1.0);
  // Labels may begin with any number, names may stand closer, the empty line may be missing.
  EXPECT_EQ(parsed(with(head, "X1\tY1\tZ1", "X5\tY5\tZ5") + rows).point_count(), 2);
  EXPECT_EQ(parsed(with(head, "Time\tLASI\t\t\tRASI\t\t", "Time\t\tLASI\t\tRASI") + rows).points[1],
            "RASI");
  EXPECT_EQ(parsed(with(head, "Z2\n\n", "Z2\n") + rows).frame_count(), 3);
  EXPECT_EQ(parsed(with(head, "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n", "") + rows).frame_count(), 3);
}

TEST(Trc, NamesThatAreEmptyAreKnownByTheirPlace) {
  const PointRecording recording = parsed(with(head, "LASI\t\t\t", "\t\t\t") + rows);
  EXPECT_EQ(recording.points, (std::vector<std::string>{"point_1", "RASI"}));
}

TEST(Trc, GapsAreEmptyCellsNaNsAndZeros) {
  const PointRecording recording = parsed(head +
                                          "1\t0.00\t\t\t\t4\t5\t6\n"
                                          "2\t0.01\tnAn\tNaN\tNAN\t0.000\t0\t-0\n"
                                          "3\t0.02\t0\t0\t1\n"
                                          "4\t0.03\n"
                                          "5\t0.04\t7\t\t9\t4\t5\t6\t \n");
  ASSERT_EQ(recording.frame_count(), 5);
  const std::vector<bool> seen = {false, true,  false, false, true,
                                  false, false, false, false, true};
  EXPECT_EQ(recording.seen, seen);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(recording.positions[i] == Vec3::Zero(), !seen[i]);
  }
  EXPECT_TRUE(has_note(recording, "1 position of exactly 0 0 0 counts as missing"));
  EXPECT_TRUE(has_note(recording, "1 position with one or two coordinates"));
  EXPECT_TRUE(has_note(recording, "says 3 frames, but the file has rows of 5"));
}

TEST(Trc, TimeIsBelievedBeforeTheHeader) {
  const PointRecording recording =
      parsed(with(head, "100\t100", "250\t250") + rows_at({{1, "0"}, {2, "0.04"}, {3, "0.08"}}));
  EXPECT_EQ(recording.frames_per_second, 25.0);
  EXPECT_TRUE(has_note(recording,
                       "The header says 250 Hz, but the Time column advances by 0.04 s: 25 Hz is "
                       "used."));
}

TEST(Trc, RatesAreThoseFromWhichTimesWereRounded) {
  for (const double rate : {29.97, 60.0, 119.88012, 120.0, 240.0, 1000.0 / 7.0}) {
    for (const int decimals : {3, 6}) {
      std::vector<std::pair<int, std::string>> times;
      for (int frame = 0; frame < 2000; ++frame) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.*f", decimals, 3.0 + frame / rate);
        times.emplace_back(frame + 1, digits);
      }
      char stated[32];
      std::snprintf(stated, sizeof stated, "%.10g\t100", rate);
      const PointRecording right = parsed(with(head, "100\t100", stated) + rows_at(times));
      EXPECT_NEAR(right.frames_per_second, rate, 1e-9 * rate);
      EXPECT_EQ(right.frame_count(), 2000);
      const PointRecording wrong = parsed(with(head, "100\t100", "77\t77") + rows_at(times));
      EXPECT_NEAR(wrong.frames_per_second, rate, 1e-3);
      EXPECT_EQ(wrong.frame_count(), 2000);
    }
  }
}

TEST(Trc, ZerosAtTheEndOfTimesDoNotMakeThemExact) {
  std::vector<std::pair<int, std::string>> times;
  for (int frame = 0; frame < 60; ++frame) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.3f000", frame / 60.0);
    times.emplace_back(frame + 1, digits);
  }
  EXPECT_EQ(parsed(with(head, "100\t100", "60\t60") + rows_at(times)).frames_per_second, 60.0);
  EXPECT_NEAR(parsed(head + rows_at(times)).frames_per_second, 60.0, 1e-9);
}

TEST(Trc, FramesWithoutARowAreGaps) {
  for (const std::string& header : {head, with(head, "100\t100", "33\t33")}) {
    const PointRecording recording = parsed(
        header + rows_at({{11, "0.10"}, {12, "0.11"}, {15, "0.14"}, {16, "0.15"}, {18, "0.17"}}));
    ASSERT_EQ(recording.frame_count(), 8);
    EXPECT_EQ(recording.frames_per_second, 100.0);
    const std::vector<double> expected = {11, 12, 0, 0, 15, 16, 0, 18};
    for (int frame = 0; frame < 8; ++frame) {
      const std::size_t i = recording.at(frame, 0);
      EXPECT_EQ(recording.positions[i].x(), expected[static_cast<std::size_t>(frame)]);
      EXPECT_EQ(recording.seen[i], expected[static_cast<std::size_t>(frame)] != 0);
      EXPECT_EQ(recording.seen[i + 1], recording.seen[i]);
    }
    EXPECT_TRUE(
        has_note(recording, "3 frames have no row in the file, the first one after frame 2"));
  }
}

TEST(Trc, ALastRowThatFollowsTooEarlyIsLeftOut) {
  const PointRecording recording =
      parsed(with(head, "100\t100", "250\t250") +
             rows_at({{1, "0"}, {2, "0.04"}, {4, "0.12"}, {5, "0.16"}, {6, "0.168"}}));
  ASSERT_EQ(recording.frame_count(), 5);
  EXPECT_FALSE(recording.seen[recording.at(2, 0)]);
  EXPECT_EQ(recording.positions[recording.at(4, 0)].x(), 5.0);
  EXPECT_TRUE(
      has_note(recording, "The last row, at 0.168 s, follows by 0.008 s instead of 0.04 s"));
}

TEST(Trc, FrameNumbersCountWhereTimeDoesNotAdvance) {
  const PointRecording recording = parsed(head + rows_at({{1, "0"}, {2, "0"}, {4, "0"}}));
  EXPECT_EQ(recording.frames_per_second, 100.0);
  EXPECT_EQ(recording.frame_count(), 4);
  EXPECT_TRUE(has_note(recording, "does not advance: the header's 100 Hz is used"));
  EXPECT_EQ(parsed(head + rows_at({{1, ""}, {2, ""}})).frame_count(), 2);
}

TEST(Trc, AGivenRateCountsWhereTimesAreUneven) {
  ReadOptions options;
  options.frames_per_second = 50.0;
  const std::string uneven = rows_at({{1, "0"}, {2, "0.013"}, {3, "0.02"}, {5, "0.5"}});
  const PointRecording recording = parse_trc(head + uneven, "walk.trc", options);
  EXPECT_EQ(recording.frames_per_second, 100.0);
  EXPECT_EQ(recording.frame_count(), 5);
  EXPECT_TRUE(has_note(recording, "not evenly spaced; the rows are taken as frames at 100 Hz"));
  const std::string no_rate = with(head, "100\t100\t", "\t\t");
  EXPECT_EQ(parse_trc(no_rate + uneven, "walk.trc", options).frames_per_second, 50.0);
  const PointRecording even =
      parse_trc(no_rate + rows_at({{1, "0"}, {2, "0.04"}}), "walk.trc", options);
  EXPECT_EQ(even.frames_per_second, 25.0);
}

TEST(Trc, IsRefusedWithItsPlaceAndFault) {
  expect_refusal("", "does not begin with PathFileType");
  expect_refusal("LASI,RASI\n1,2\n", "walk.trc:1:1: is not a TRC file");
  expect_refusal(with(head, "Frame#\tTime", "Frame# Time"), "walk.trc:4:1: the fourth line");
}

TEST(Trc, IsRefusedRowByRow) {
  expect_refusal(head, "there are no rows");
  expect_refusal(with(head, "LASI\t\t\tRASI\t\t", "LASI\t\t\tMID\t\t\tRASI") + rows,
                 "walk.trc:4:1: 3 points are named, but the next line has coordinates of 2");
  expect_refusal(head + with(rows, "-5", "five"),
                 "walk.trc:7:18: \"five\" is not a valid coordinate");
  expect_refusal(head + with(rows, "-5", "0,5"), "write decimals with a point");
  expect_refusal(head + with(rows, "-5", "1e13"), "is not a valid coordinate");
  expect_refusal(head + with(rows, "-5", "inf"), "is not a valid coordinate");
  expect_refusal(head + with(rows, "6e1", "6\t7"),
                 "walk.trc:7:23: the row has more cells than the 2");
  expect_refusal(head + with(rows, "2\t0.01", "two\t0.01"),
                 "walk.trc:8:1: the row begins with \"two\"");
  expect_refusal(head + with(rows, "0.01", "soon"), "walk.trc:8:1: the time \"soon\"");
  expect_refusal(head + with(rows, "0.01", ""), "walk.trc:8:1: the row has no time");
  expect_refusal(head + with(rows, "0.02", "0.005"),
                 "walk.trc:9:1: Time goes from 0.01 to 0.005 s");
  expect_refusal(with(head, "100\t100\t3", "0\t0\t3") + rows_at({{1, "0"}, {2, "0"}}),
                 "neither the header nor the Time column states a frame rate");
}

TEST(Trc, UnevenTimesAreRefusedWhereTheSpacingChanges) {
  std::vector<std::pair<int, std::string>> times;
  for (int i = 0; i < 20; ++i) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.4f", i < 12 ? 0.01 * i : 0.11 + 0.015 * (i - 11));
    times.emplace_back(i + 1, digits);
  }
  expect_refusal(
      head + rows_at(times),
      "walk.trc:19:1: Time advances by 0.015 s, but usually by 0.01 s; if the frames are "
      "evenly spaced all the same, state their rate with fps:");
}

TEST(Trc, FramesFarApartDoNotFillTheMemory) {
  expect_refusal(head + rows_at({{1, "0"}, {900'000'000, "8999999.99"}}),
                 "are too many for a file");
  std::string wide = with(head, "100\t100\t3\t2", "100\t100\t3\t30000");
  std::string names, labels;
  for (int i = 0; i < 30'000; ++i) {
    names += "\tm\t\t";
    labels += "\tX\tY\tZ";
  }
  wide = with(with(wide, "\tLASI\t\t\tRASI\t\t", names), "\tX1\tY1\tZ1\tX2\tY2\tZ2", labels);
  std::string short_rows;
  for (int i = 0; i < 30'000; ++i) short_rows += std::to_string(i) + "\t\n";
  expect_refusal(wide + short_rows, "are too many for a file");
}

PointRecording random_recording(std::mt19937_64& random, double metres_per_unit) {
  std::uniform_real_distribution<double> place(-3.0 / metres_per_unit, 3.0 / metres_per_unit);
  PointRecording recording;
  recording.name = "random";
  recording.unit = metres_per_unit == 1.0 ? "m" : "x";
  recording.metres_per_unit = metres_per_unit;
  recording.frames_per_second = 119.88;
  for (int i = 0; i < 7; ++i) recording.points.push_back("P" + std::to_string(i));
  for (int i = 0; i < 7 * 50; ++i) {
    recording.seen.push_back(random() % 4 != 0);
    const Vec3 position(place(random), place(random), place(random));
    recording.positions.push_back(recording.seen.back() ? position : Vec3::Zero());
  }
  return recording;
}

TEST(TrcWriter, WritesWhatIsReadAgain) {
  std::mt19937_64 random(3);
  for (const double metres : {1.0, 0.01, 0.001, 0.0254}) {
    const PointRecording written = random_recording(random, metres);
    const std::string text = to_trc(written);
    EXPECT_EQ(text, to_trc(written));
    const PointRecording read = parse_trc(text, "random.trc");
    EXPECT_EQ(all_notes(read), "");
    EXPECT_EQ(read.points, written.points);
    EXPECT_EQ(read.seen, written.seen);
    EXPECT_EQ(read.frames_per_second, written.frames_per_second);
    EXPECT_EQ(read.unit, metres == 1.0 ? "m" : "mm");
    ASSERT_EQ(read.positions.size(), written.positions.size());
    for (std::size_t i = 0; i < read.positions.size(); ++i) {
      const Vec3 difference =
          read.positions[i] * read.metres_per_unit - written.positions[i] * metres;
      EXPECT_LT(difference.cwiseAbs().maxCoeff(), 0.6e-7);  // metres
    }
  }
}

TEST(TrcWriter, PutsNoSeenPointAtTheOrigin) {
  PointRecording recording;
  recording.points = {"a\tb", "c"};
  recording.metres_per_unit = 0.001;
  recording.positions = {Vec3::Zero(), Vec3(-1e-5, 2e-5, -3e-5)};
  recording.seen = {true, true};
  const PointRecording read = parse_trc(to_trc(recording), "origin.trc");
  EXPECT_EQ(read.points, (std::vector<std::string>{"a_b", "c"}));
  EXPECT_EQ(read.seen, recording.seen);
  for (const Vec3& position : read.positions) EXPECT_LT(position.norm(), 0.001);
}

TEST(TrcWriter, AsksForTheUnit) {
  std::mt19937_64 random(4);
  PointRecording recording = random_recording(random, 1.0);
  recording.metres_per_unit = 0.0;
  EXPECT_NE(refusal_of([&] { to_trc(recording); }).find("unit of its positions is not known"),
            std::string::npos);
  EXPECT_NE(refusal_of([] { to_trc({}); }).find("without points or frames"), std::string::npos);
}

TEST(TrcFiles, GoToDiskAndBack) {
  std::mt19937_64 random(5);
  const PointRecording recording = random_recording(random, 0.001);
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "mien_test.trc";
  write_result(path, to_trc(recording));
  EXPECT_EQ(read_contents(path), to_trc(recording));
  EXPECT_EQ(read_trc(path).name, "mien_test");
  std::filesystem::remove(path);
}

TEST(Trc, PeopleAreInTheNamesOfPoints) {
  const std::string text = with(with(head, "LASI", "Ann:LASI"), "RASI", "Bo:LASI") + rows;
  const PointRecording all = parsed(text);
  EXPECT_EQ(all.points, (std::vector<std::string>{"Ann:LASI", "Bo:LASI"}));
  EXPECT_EQ(all.subjects, (std::vector<std::string>{"Ann", "Bo"}));
  EXPECT_TRUE(has_note(all, "2 people or objects (Ann, Bo); all are read")) << all_notes(all);
  ReadOptions options;
  for (const char* wanted : {"Bo", "2"}) {
    options.subject = wanted;
    const PointRecording bo = parse_trc(text, "walk.trc", options);
    EXPECT_EQ(bo.points, std::vector<std::string>{"LASI"});
    EXPECT_EQ(bo.subject, "Bo");
    EXPECT_EQ(bo.positions[0], Vec3(4.5, -5, 60));
  }
  options.subject = "Cy";
  const std::string said = refusal_of([&] { parse_trc(text, "walk.trc", options); });
  EXPECT_NE(said.find("it holds Ann, Bo: choose one of these"), std::string::npos) << said;
  const std::string none = refusal_of([&] { parse_trc(head + rows, "walk.trc", options); });
  EXPECT_NE(none.find("names no people, so \"Cy\" cannot be chosen"), std::string::npos) << none;
}

}  // namespace
}  // namespace mien::motion
