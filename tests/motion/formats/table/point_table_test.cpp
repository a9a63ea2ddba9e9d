#include "motion/formats/table/point_table.h"

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/table/tidy_csv.h"
#include "motion/points/joint_orders.h"
#include "motion/refusal.h"
#include "motion/text/excerpt.h"

namespace mien::motion {
namespace {

using mien::test::refusal_of;

const std::array<std::string, 2> points = {"nose", "left_knee"};

/// A position that tells frame, point and axis.
double made(int frame, int point, int axis) { return 0.125 + frame + 100.0 * point + 0.25 * axis; }

std::string as_text(double value, char decimal_mark = '.') {
  std::string text = std::to_string(value);
  if (decimal_mark != '.') text[text.find('.')] = decimal_mark;
  return text;
}

using Naming = std::function<std::string(const std::string& point, char axis)>;

std::string underscore(const std::string& point, char axis) { return point + "_" + axis; }

/// A wide table at 50 Hz, written without the reader's code.
std::string wide(const Naming& name, char separator = ',', char decimal_mark = '.',
                 const std::string& line_end = "\n", int frames = 4) {
  std::string text = "frame" + std::string(1, separator) + "time";
  for (const std::string& point : points)
    for (const char axis : {'x', 'y', 'z'}) text += separator + name(point, axis);
  text += line_end;
  for (int f = 0; f < frames; ++f) {
    text += std::to_string(f + 1) + separator + as_text(0.02 * f, decimal_mark);
    for (int p = 0; p < 2; ++p)
      for (int axis = 0; axis < 3; ++axis)
        text += separator + as_text(made(f, p, axis), decimal_mark);
    text += line_end;
  }
  return text;
}

void expect_made(const PointRecording& recording, int frames = 4) {
  ASSERT_EQ(recording.points, (std::vector<std::string>{"nose", "left_knee"}));
  ASSERT_EQ(recording.frame_count(), frames);
  EXPECT_DOUBLE_EQ(recording.frames_per_second, 50.0);
  for (int f = 0; f < frames; ++f)
    for (int p = 0; p < 2; ++p)
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_TRUE(recording.seen[recording.at(f, p)]);
        EXPECT_DOUBLE_EQ(recording.positions[recording.at(f, p)][axis], made(f, p, axis));
      }
}

bool is_noted(const PointRecording& recording, const std::string& words) {
  for (const std::string& note : recording.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

/// With rows of the columns frame, a_x, a_y, a_z.
PointRecording with_rows(const std::string& rows, const ReadOptions& options = {}) {
  return parse_point_table("frame,a_x,a_y,a_z\n" + rows, "some/walk.csv", options);
}

ReadOptions at_rate(double rate) {
  ReadOptions options;
  options.frames_per_second = rate;
  return options;
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  return refusal_of([&] { parse_point_table(text, "walk.csv", options); });
}

void expect_words(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "\"" << words << "\" is not in: " << text;
}

TEST(PointTable, ColumnsMayBeNamedInManyWays) {
  const std::vector<Naming> namings = {
      underscore,
      [](auto& point, char axis) { return point + "." + static_cast<char>(axis - 32); },
      [](auto& point, char axis) { return point + " " + static_cast<char>(axis - 32); },
      [](auto& point, char axis) { return std::string(1, axis) + "_" + point; },
      [](auto& point, char axis) { return static_cast<char>(axis - 32) + ("_" + point); },
      [](auto& point, char axis) { return point + static_cast<char>(axis - 32); },
      [](auto& point, char axis) { return point + "_pos_" + axis; },
      [](auto& point, char axis) { return "\"" + point + "_" + axis + "\""; }};
  for (const Naming& naming : namings) {
    SCOPED_TRACE(naming("nose", 'x'));
    expect_made(parse_point_table(wide(naming), "walk.csv"));
  }
}

TEST(PointTable, TheNameTellsTheUnit) {
  const PointRecording in_brackets = parse_point_table(
      wide([](auto& point, char axis) { return point + "_" + axis + " [mm]"; }), "walk.csv");
  expect_made(in_brackets);
  EXPECT_EQ(in_brackets.unit, "mm");
  EXPECT_EQ(in_brackets.metres_per_unit, 0.001);
  const PointRecording at_end = parse_point_table(
      wide([](auto& point, char axis) { return point + "_" + axis + "_m"; }), "walk.csv");
  expect_made(at_end);
  EXPECT_EQ(at_end.unit, "m");
  const PointRecording without = parse_point_table(wide(underscore), "a/walk.csv");
  EXPECT_EQ(without.unit, "");
  EXPECT_EQ(without.metres_per_unit, 0.0);
  EXPECT_EQ(without.name, "walk");
  EXPECT_EQ(without.format, "csv");
}

TEST(PointTable, SeparatorsAndDecimalCommasAreFound) {
  for (const char separator : {',', ';', '\t'}) {
    expect_made(parse_point_table(wide(underscore, separator, '.', "\r\n"), "walk.csv"));
    expect_made(
        parse_point_table("\xEF\xBB\xBF" + wide(underscore, separator, '.', "\r"), "w.csv"));
    if (separator != ',')
      expect_made(parse_point_table(wide(underscore, separator, ','), "walk.csv"));
  }
  expect_words(refusal("frame;a_x;a_y;a_z\n1;1,5;1.234;2\n2;1;1;1\n", at_rate(50)),
               "decimal commas and decimal points");
}

TEST(PointTable, CommentsAndEmptyLinesAreSkipped) {
  expect_made(
      parse_point_table("# Take: 3, a, b\n\n" + wide(underscore) + "\n# end\n,,,\n", "w.csv"));
}

TEST(PointTable, ACommentMayNameTheColumns) {
  const PointRecording recording =
      parse_point_table("# t, a_x, a_y, a_z\n0.00,1,2,3\n0.01,1,2,3\n", "walk.csv");
  EXPECT_EQ(recording.points, std::vector<std::string>{"a"});
  EXPECT_EQ(recording.frames_per_second, 100.0);
  ASSERT_EQ(recording.frame_count(), 2);
}

TEST(PointTable, WithoutAHeaderTheOptionsNameThePoints) {
  ReadOptions options = at_rate(50);
  expect_words(refusal("1,2,3,4,5,6\n", options), "there is no header");
  options.joints = {"a", "b"};
  const PointRecording recording =
      parse_point_table("1,2,3,4,5,6\n1,2,3,7,8,9\n", "w.csv", options);
  EXPECT_EQ(recording.points, options.joints);
  EXPECT_EQ(recording.positions[recording.at(1, 1)], Vec3(7, 8, 9));
  expect_words(refusal("1,2,3\n", options), "3 columns, but 2 points are named");
}

TEST(PointTable, WithoutAHeaderAKnownOrderNamesThePoints) {
  ReadOptions options = at_rate(50);
  options.joints = {"h36m"};
  std::string row;
  for (int i = 0; i < 3 * 17; ++i) row += (i > 0 ? "," : "") + std::to_string(i);
  const PointRecording recording = parse_point_table(row + "\n", "w.csv", options);
  ASSERT_EQ(recording.point_count(), 17);
  EXPECT_EQ(recording.points[0], joint_order("h36m")->joints[0]);
  EXPECT_EQ(recording.positions[16], Vec3(48, 49, 50));
}

TEST(PointTable, PartsOfTheBodyAreNoUnits) {
  const PointRecording recording = parse_point_table(
      "frame,x_left_foot,y_left_foot,z_left_foot\n1,1,2,3\n", "w.csv", at_rate(50));
  EXPECT_EQ(recording.points, std::vector<std::string>{"left_foot"});
  EXPECT_EQ(recording.unit, "");
  EXPECT_EQ(parse_point_table("frame,a_x (ft),a_y (ft),a_z (ft)\n1,1,2,3\n", "w.csv", at_rate(50))
                .metres_per_unit,
            0.3048);
}

// Otherwise people who appear at different times would not be shown together.
TEST(PointTable, LongTablesHaveOneTimeForAllPeople) {
  const std::string text =
      "frame,person,point,x,y,z\n1,Ann,a,1,2,3\n2,Ann,a,1,2,3\n2,Bob,b,4,5,6\n3,Bob,b,4,5,7\n";
  ReadOptions options = at_rate(50);
  for (const char* const chosen : {"Ann", "Bob"}) {
    options.subject = chosen;
    EXPECT_EQ(parse_point_table(text, "w.csv", options).frame_count(), 3) << chosen;
  }
  const PointRecording bob = parse_point_table(text, "w.csv", options);
  EXPECT_EQ(bob.points, std::vector<std::string>{"b"});
  EXPECT_EQ(bob.seen, (std::vector<bool>{false, true, true}));
  EXPECT_EQ(bob.positions[1], Vec3(4, 5, 6));
}

TEST(PointTable, MissingPositionsAreNotAtTheOrigin) {
  const PointRecording recording =
      with_rows("1,1,2,3\n2,,,\n3,NaN,nan,NAN\n4,NA,n/a,null\n5,1,,3\n6,#N/A,-nan,None\n7,4,5,6\n",
                at_rate(50));
  ASSERT_EQ(recording.frame_count(), 7);
  EXPECT_EQ(recording.seen, (std::vector<bool>{true, false, false, false, false, false, true}));
  for (int f = 1; f < 6; ++f) EXPECT_EQ(recording.positions[recording.at(f, 0)], Vec3::Zero());
  EXPECT_TRUE(is_noted(recording, "In 1 place only one or two coordinates"));
}

TEST(PointTable, RowsMayEndShort) {
  const PointRecording recording = with_rows("1,1,2,3\n2\n3,1,2\n4,1,2,3,,,\n", at_rate(50));
  EXPECT_EQ(recording.seen, (std::vector<bool>{true, false, false, true}));
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,2,3,4\n", at_rate(50)),
               "walk.csv:2:9: the row has more than the 4 columns");
}

TEST(PointTable, FrameNumbersLeaveGaps) {
  const PointRecording recording = with_rows("11,1,1,1\n12,2,2,2\n15,5,5,5\n", at_rate(50));
  ASSERT_EQ(recording.frame_count(), 5);
  EXPECT_EQ(recording.seen, (std::vector<bool>{true, true, false, false, true}));
  EXPECT_EQ(recording.positions[4], Vec3(5, 5, 5));
  EXPECT_TRUE(is_noted(recording, "2 of 5 frames have no row"));
  const PointRecording fifths = with_rows("0,1,1,1\n5,2,2,2\n15,5,5,5\n", at_rate(50));
  EXPECT_EQ(fifths.seen, (std::vector<bool>{true, true, false, true}));
  EXPECT_TRUE(is_noted(fifths, "multiples of 5"));
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,1,1\n3,1,1,1\n2,1,1,1\n", at_rate(50)),
               "walk.csv:4:1: frame 2 follows frame 3");
}

/// A table with times only.
std::string timed(const std::string& name, const std::vector<std::string>& times) {
  std::string text = name + ",a_x,a_y,a_z\n";
  for (const std::string& time : times) text += time + ",1,2,3\n";
  return text;
}

TEST(PointTable, TimesGiveTheRate) {
  const auto rate_of = [](const std::string& name, const std::vector<std::string>& times) {
    return parse_point_table(timed(name, times), "w.csv").frames_per_second;
  };
  EXPECT_EQ(rate_of("time", {"0", "0.0083", "0.0167", "0.025", "0.0333", "0.0417"}), 120.0);
  EXPECT_EQ(rate_of("Time (Seconds)", {"10.000", "10.040", "10.080"}), 25.0);
  EXPECT_EQ(rate_of("time_ms", {"0", "33", "67", "100", "133", "167"}), 30.0);
  EXPECT_EQ(rate_of("t [ms]", {"0", "10", "20"}), 100.0);
  EXPECT_NEAR(rate_of("t", {"0", "0.0333667", "0.0667333", "0.1001"}), 30000.0 / 1001.0, 1e-9);
  EXPECT_NEAR(rate_of("seconds", {"0", "0.0303", "0.0606", "0.0909"}), 33.0, 0.01);
}

TEST(PointTable, TimesWithoutAUnitThatWouldBeTooSlowAreMilliseconds) {
  const PointRecording recording =
      parse_point_table(timed("timestamp", {"33", "67", "100", "133"}), "w.csv");
  EXPECT_EQ(recording.frames_per_second, 30.0);
  EXPECT_TRUE(is_noted(recording, "taken as milliseconds"));
}

TEST(PointTable, TimesLeaveGaps) {
  const PointRecording recording =
      parse_point_table(timed("time", {"0", "0.01", "0.02", "0.05", "0.06"}), "w.csv");
  EXPECT_EQ(recording.frames_per_second, 100.0);
  EXPECT_EQ(recording.seen, (std::vector<bool>{true, true, true, false, false, true, true}));
}

TEST(PointTable, UnevenTimesAreRefusedAtTheirRow) {
  const std::vector<std::string> times = {"0", "0.01", "0.02", "0.0342", "0.04", "0.05"};
  expect_words(refusal(timed("time", times)),
               "walk.csv:5:1: the times are not evenly spaced: that of row 4, 0.0342");
  const PointRecording told = parse_point_table(timed("time", times), "w.csv", at_rate(100));
  EXPECT_EQ(told.frame_count(), 6);
  EXPECT_TRUE(is_noted(told, "not evenly spaced"));
  expect_words(refusal(timed("time", {"0.000", "0.010", "0.010", "0.020"})), "not evenly spaced");
  expect_words(refusal(timed("time", {"0", "", "0.01"})), "no value for the time");
}

TEST(PointTable, WithoutARateItAsksForOne) {
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,2,3\n2,1,2,3\n"), "fps:");
  expect_words(refusal(timed("time", {"0"})), "fps:");
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,2,3\n", at_rate(0)), "not usable");
}

TEST(PointTable, WhatIsNoPositionIsLeftOutWithANote) {
  const PointRecording recording = parse_point_table(
      "frame,a_x,a_y,a_z,a_rot_x,a_rot_y,a_rot_z,q_x,q_y,q_z,q_w,b_x,b_y,score,label\n"
      "1,1,2,3,4,5,6,7,8,9,1,2,3,0.9,walk\n",
      "w.csv", at_rate(50));
  EXPECT_EQ(recording.points, std::vector<std::string>{"a"});
  EXPECT_TRUE(is_noted(recording, "a_rot_x, a_rot_y, a_rot_z, q_x, q_y and 6 more"));
}

TEST(PointTable, TwoDimensionalKeypointsAreRefused) {
  expect_words(refusal("frame,a_x,a_y,b_x,b_y\n1,1,2,3,4\n", at_rate(50)), "two-dimensional");
  expect_words(refusal("bodyparts,nose,nose,nose\ncoords,x,y,likelihood\n0,1,2,0.9\n", at_rate(50)),
               "two-dimensional");
}

TEST(PointTable, NamesMayStandAboveTheAxes) {
  const std::string rows = "1,1,2,3,4,5,6\n2,1,2,3,4,5,7\n";
  for (const std::string& header :
       {std::string(",nose,,,knee,,\nframe,x,y,z,x,y,z\n"),
        std::string("scorer,me,me,me,me,me,me\nbodyparts,nose,nose,nose,knee,knee,knee\n"
                    "coords,x,y,z,x,y,z\n"),
        std::string(",nose,,,knee,,\nFrame,X,Y,Z,X,Y,Z\n,mm,mm,mm,mm,mm,mm\n")}) {
    const PointRecording recording = parse_point_table(header + rows, "w.csv", at_rate(50));
    EXPECT_EQ(recording.points, (std::vector<std::string>{"nose", "knee"})) << header;
    EXPECT_EQ(recording.positions[recording.at(1, 1)], Vec3(4, 5, 7));
    EXPECT_EQ(recording.unit, header.find("mm") == std::string::npos ? "" : "mm");
  }
}

TEST(PointTable, PositionsAtTheOriginAreKeptWithANote) {
  const PointRecording recording = with_rows("1,0,0,0\n2,1,2,3\n", at_rate(50));
  EXPECT_TRUE(recording.seen[0]);
  EXPECT_TRUE(is_noted(recording, "exactly 0 0 0"));
}

TEST(PointTable, SubjectsAreInTheNames) {
  const std::string text =
      "frame,A:nose_x,A:nose_y,A:nose_z,B:nose_x,B:nose_y,B:nose_z\n1,1,2,3,4,5,6\n";
  const PointRecording all = parse_point_table(text, "w.csv", at_rate(50));
  EXPECT_EQ(all.points, (std::vector<std::string>{"A:nose", "B:nose"}));
  EXPECT_EQ(all.subjects, (std::vector<std::string>{"A", "B"}));
  EXPECT_TRUE(is_noted(all, "Choose one with subject:"));
  ReadOptions options = at_rate(50);
  for (const char* const chosen : {"B", "2"}) {
    options.subject = chosen;
    const PointRecording one = parse_point_table(text, "w.csv", options);
    EXPECT_EQ(one.points, std::vector<std::string>{"nose"});
    EXPECT_EQ(one.subject, "B");
    EXPECT_EQ(one.positions[0], Vec3(4, 5, 6));
  }
  options.subject = "C";
  expect_words(refusal(text, options), "it holds A, B: choose one of these");
}

TEST(PointTable, MotiveExportsAreRead) {
  const std::string text =
      "Format Version,1.23,Take Name,Walk,Capture Frame Rate,120.000000,Export Frame Rate,"
      "120.000000,Rotation Type,Quaternion,Length Units,Centimeters,Coordinate Space,Global\n\n"
      ",,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid "
      "Body,Marker,Marker,Marker,Marker,Marker,Marker\n"
      ",,Hip,Hip,Hip,Hip,Hip,\"P:LASI\",\"P:LASI\",\"P:LASI\",P:RASI,P:RASI,P:RASI\n"
      ",,1,1,1,1,1,2,2,2,3,3,3\n"
      ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Position,Position,Position,"
      "Position\n"
      "Frame,Time (Seconds),X,Y,Z,W,X,X,Y,Z,X,Y,Z\n"
      "0,0.000000,0,0,0,1,9,1,2,3,4,5,6\n1,0.008333,0,0,0,1,9,1,2,3,,,\n"
      "2,0.016667,0,0,0,1,9,1,2,3,4,5,7\n";
  const PointRecording recording = parse_point_table(text, "take.csv");
  EXPECT_EQ(recording.points, (std::vector<std::string>{"LASI", "RASI"}));
  EXPECT_EQ(recording.subject, "P");
  EXPECT_EQ(recording.frames_per_second, 120.0);
  EXPECT_EQ(recording.unit, "cm");
  EXPECT_FALSE(recording.seen[recording.at(1, 1)]);
  EXPECT_EQ(recording.positions[recording.at(2, 1)], Vec3(4, 5, 7));
  EXPECT_TRUE(is_noted(recording, "Rigid Body Rotation, Rigid Body Position"));
  EXPECT_FALSE(is_noted(recording, "Hz"));
}

TEST(PointTable, MotiveExportsOfVersion3AreRead) {
  const std::string text =
      "Format Version,1.24,Export Frame Rate,100.000000,Length Units,Meters\n\n"
      ",Type,,Marker,Marker,Marker\n,Name,,Unlabeled 1189,Unlabeled 1189,Unlabeled 1189\n"
      ",ID,,\"4CF0\",\"4CF0\",\"4CF0\"\n,Parent,,,,\n,,,Position,Position,Position\n"
      "Frame,Time (Seconds),TimeCode,X,Y,Z\n0,0.000000,15:26:46:12.02,1,2,3\n"
      "1,0.010000,15:26:46:13.02,1,2,4\n";
  const PointRecording recording = parse_point_table(text, "take.csv");
  EXPECT_EQ(recording.points, std::vector<std::string>{"Unlabeled 1189"});
  EXPECT_EQ(recording.positions[1], Vec3(1, 2, 4));
  EXPECT_EQ(recording.unit, "m");
}

TEST(PointTable, QualisysExportsAreRead) {
  const std::string head =
      "NO_OF_FRAMES\t3\r\nNO_OF_CAMERAS\t20\r\nNO_OF_MARKERS\t2\r\nFREQUENCY\t200\r\n"
      "NO_OF_ANALOG\t0\r\nANALOG_FREQUENCY\t0\r\nDESCRIPTION\t--\r\n"
      "TIME_STAMP\t2022-06-03, 10:47:36.627\t94247.45\r\nDATA_INCLUDED\t3D\r\n"
      "EVENT\tstart\t2\t0.005\r\nMARKER_NAMES\tx_Head\tLKnee\r\nTRAJECTORY_"
      "TYPES\tMeasured\tMixed\r\n";
  const std::string positions[] = {"1.500\t2.000\t3.000\t4.000\t5.000\t6.000",
                                   "0.000\t0.000\t0.000\t4.000\t5.000\t6.000",
                                   "1.500\t2.000\t3.000\t4.000\t5.000\t7.000"};
  const std::string counted[] = {"1\t0.000\t", "2\t0.005\t", "3\t0.010\t"};
  for (const std::string& names :
       {std::string(), std::string("counted"),
        std::string("Frame\tTime\tx_Head X\tx_Head Y\tx_Head Z\tLKnee X\tLKnee Y\tLKnee Z\r\n")}) {
    SCOPED_TRACE(names);
    std::string text = head + (names == "counted" ? "" : names);
    for (int f = 0; f < 3; ++f)
      text +=
          (names.empty() ? "" : counted[f]) + positions[f] + (names.empty() ? "\t" : "") + "\r\n";
    const PointRecording recording = parse_point_table(text, "walk.tsv");
    EXPECT_EQ(recording.points, (std::vector<std::string>{"x_Head", "LKnee"}));
    EXPECT_EQ(recording.frames_per_second, 200.0);
    EXPECT_EQ(recording.unit, "mm");
    EXPECT_EQ(recording.format, "tsv");
    ASSERT_EQ(recording.frame_count(), 3);
    EXPECT_FALSE(recording.seen[recording.at(1, 0)]);
    EXPECT_EQ(recording.positions[recording.at(0, 0)], Vec3(1.5, 2, 3));
    EXPECT_EQ(recording.positions[recording.at(2, 1)], Vec3(4, 5, 7));
    ASSERT_EQ(recording.events.size(), 1u);
    EXPECT_EQ(recording.events[0].label, "start");
    EXPECT_EQ(recording.events[0].seconds, 0.005);
    EXPECT_FALSE(is_noted(recording, "frames, but"));
  }
  std::string many = head + positions[0] + "\r\n";
  many.replace(many.find("\t3\r"), 2, "\t1000000000");
  const PointRecording one = parse_point_table(many, "walk.tsv");
  EXPECT_EQ(one.frame_count(), 1);
  EXPECT_TRUE(is_noted(one, "1000000000 frames, but the file has 1"));
  many.replace(many.find("3D"), 2, "6D");
  expect_words(refusal(many), "holds \"6D\" data");
}

TEST(PointTable, NexusExportsAreRead) {
  const std::string text =
      "Trajectories,,,,,,,\n100,,,,,,,\n,,P:LASI,,,P:RASI,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n"
      ",,mm,mm,mm,mm,mm,mm\n5,0,1,2,3,4,5,6\n6,0,1,2,3,,,\n\nModel Outputs,,\n100\n";
  const PointRecording recording = parse_point_table(text, "walk.csv");
  EXPECT_EQ(recording.points, (std::vector<std::string>{"LASI", "RASI"}));
  EXPECT_EQ(recording.frames_per_second, 100.0);
  EXPECT_EQ(recording.unit, "mm");
  EXPECT_EQ(recording.frame_count(), 2);
  EXPECT_TRUE(is_noted(recording, "\"Model Outputs\" follows"));
}

TEST(PointTable, NexusExportsWithEventsAndDevicesBeforeTheTrajectoriesAreRead) {
  const std::string before =
      "Events\n100\nSubject,Context,Name,Time (s),Description\nP,Left,Foot Strike,0.5,\n\n"
      "Devices\n1000\n,,Force plate,,\nFrame,Sub Frame,Fx,Fy,Fz\n,,N,N,N\n5,0,1,2,3\n\n";
  const std::string text =
      before +
      "Trajectories\n100\n,,P:LASI,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n5,0,1,2,3\n6,0,4,5,6\n";
  const PointRecording recording = parse_point_table(text, "walk.csv");
  EXPECT_EQ(recording.points, std::vector<std::string>{"LASI"});
  EXPECT_EQ(recording.frame_count(), 2);
  EXPECT_EQ(recording.positions[1], Vec3(4, 5, 6));
  EXPECT_TRUE(is_noted(recording, "others were left out: \"Events\", \"Devices\"") ||
              is_noted(recording, "others were left out: Events, Devices"));
}

TEST(PointTable, LongTablesMayBeInAnyOrder) {
  const std::string text =
      "z,point,x,frame,y,note\n3,a,1,7,2,n\n6,b,4,7,5,n\n9,a,7,9,8,n\n,b,,8,,n\n";
  const PointRecording recording = parse_point_table(text, "w.csv", at_rate(50));
  EXPECT_EQ(recording.points, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(recording.frame_count(), 3);
  EXPECT_EQ(recording.seen, (std::vector<bool>{true, true, false, false, true, false}));
  EXPECT_EQ(recording.positions[recording.at(0, 1)], Vec3(4, 5, 6));
  EXPECT_EQ(recording.positions[recording.at(2, 0)], Vec3(7, 8, 9));
  EXPECT_TRUE(is_noted(recording, "The column note is no position"));
  expect_words(refusal("frame,point,x,y,z\n1,a,1,2,3\n2,a,1,2,3\n1,a,1,2,3\n", at_rate(50)),
               "walk.csv:4:1: the point \"a\" occurs twice");
}

TEST(PointTable, LongTablesHaveTimesAndPeople) {
  const std::string text =
      "time_s,person,marker,x_mm,y_mm,z_mm\n0,Ann,a,1,2,3\n0,Bob,b,4,5,6\n0.01,Ann,a,1,2,3\n"
      "0.01,Bob,b,4,5,7\n";
  const PointRecording first = parse_point_table(text, "w.csv");
  EXPECT_EQ(first.points, std::vector<std::string>{"a"});
  EXPECT_EQ(first.subject, "Ann");
  EXPECT_EQ(first.frames_per_second, 100.0);
  EXPECT_EQ(first.unit, "mm");
  EXPECT_TRUE(is_noted(first, "2 people (Ann, Bob); \"Ann\" is used"));
  ReadOptions options;
  options.subject = "Bob";
  const PointRecording second = parse_point_table(text, "w.csv", options);
  EXPECT_EQ(second.points, std::vector<std::string>{"b"});
  EXPECT_EQ(second.positions[1], Vec3(4, 5, 7));
}

TEST(PointTable, FreeMocapTablesKeepModelsApart) {
  const PointRecording recording = parse_point_table(
      "frame,timestamp,timestamp_by_camera,model,keypoint,x,y,z,reprojection_error\n"
      "0,,{},mediapipe_body,nose,1,2,3,0.1\n0,,{},mediapipe_body,wrist,1,2,4,0.1\n"
      "0,,{},mediapipe_hand,wrist,1,2,5,0.1\n",
      "w.csv", at_rate(30));
  EXPECT_EQ(recording.points,
            (std::vector<std::string>{"nose", "mediapipe_body wrist", "mediapipe_hand wrist"}));
  EXPECT_EQ(recording.positions[2], Vec3(1, 2, 5));
}

TEST(PointTable, BadCellsAreRefusedAtTheirPlace) {
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,two,3\n", at_rate(50)),
               "walk.csv:2:5: \"two\" is not a usable number for y of \"a\"");
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,1e13,3\n", at_rate(50)), "\"1e13\" is not a usable");
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,inf,3\n", at_rate(50)), "\"inf\" is not a usable");
  expect_words(refusal("frame,a_x,a_y,a_z\n1.5,1,2,3\n", at_rate(50)), "the number of the frame");
  expect_words(refusal("frame,\"a_x,a_y,a_z\n1,1,2,3\n"), "a quote is not closed");
  expect_words(refusal("frame,\"a\"_x,a_y,a_z\n1,1,2,3\n"), "text follows a closing quote");
  expect_words(refusal("frame,a_x,a_y,a_z\n", at_rate(50)), "there are no frames");
  expect_words(refusal("name,age\nAnn,three\n"), "no columns of points are found");
  expect_words(refusal(""), "there are no rows");
  expect_words(refusal("frame,a_x (mm),a_y (m),a_z (mm)\n1,1,2,3\n", at_rate(50)),
               "different units");
}

TEST(PointTable, DeclaredSizesAreNotBelieved) {
  expect_words(refusal("frame,a_x,a_y,a_z\n1,1,2,3\n2,1,2,3\n1000000000,1,2,3\n", at_rate(50)),
               "far more than the file holds");
  expect_words(refusal("time,a_x,a_y,a_z\n0,1,2,3\n0.01,1,2,3\n0.02,1,2,3\n9999999,1,2,3\n"),
               "far more than the file holds");
  std::string columns = "frame";
  for (int i = 0; i < 1'000'000; ++i) columns += ",a";
  expect_words(refusal(columns + "\n1\n"), "more than 262144 columns");
  const std::string line(10'000'000, 'x');
  EXPECT_LT(refusal("frame,a_x,a_y,a_z\n1,1," + line + ",3\n", at_rate(50)).size(), 400u);
  EXPECT_LT(refusal(line).size(), 400u);
  std::string many = "frame";
  for (int i = 0; i < 70'000; ++i)
    for (const char* const axis : {"_x", "_y", "_z"}) many += ',' + std::to_string(i) + axis;
  expect_words(refusal(many + "\n1,1\n", at_rate(50)), "70000 points are more than can be read");
}

TEST(PointTable, HostileTextIsQuotedHarmlessly) {
  const std::string hostile = "\x1b[2J\x07\xff";
  for (const std::string& text :
       {"frame,a_x,a_y,a_z\n1," + hostile + ",2,3\n", "frame," + hostile + "_x\n",
        "frame,point,x,y,z\n1," + hostile + ",1,2,3\n1," + hostile + ",1,2,3\n"}) {
    const std::string words = refusal(text, at_rate(50));
    EXPECT_EQ(printable(words), words);
  }
}

TEST(PointTable, TidyTablesReadBack) {
  PointRecording recording =
      with_rows("1,1234.5678,-0.00004,3\n2,,,\n4,1e-9,2,3\n", at_rate(59.94));
  recording.points = {"a, \"b\"; 'c'"};
  recording.unit = "mm";
  recording.metres_per_unit = 0.001;
  const std::string text = to_tidy_csv(recording);
  EXPECT_EQ(text.substr(0, text.find('\n', 40)),
            "frame,time_s,point,x_m,y_m,z_m\n0,0,\"a, \"\"b\"\"; 'c'\",1.2345678,0,0.003");
  const PointRecording again = parse_point_table(text, "walk.csv");
  EXPECT_EQ(again.points, recording.points);
  EXPECT_EQ(again.seen, recording.seen);
  EXPECT_EQ(again.unit, "m");
  EXPECT_NEAR(again.frames_per_second, 59.94, 0.001);
  for (std::size_t i = 0; i < recording.positions.size(); ++i)
    EXPECT_LT((again.positions[i] - 0.001 * recording.positions[i]).norm(), 1e-6);
  recording.metres_per_unit = 0.0;
  const PointRecording unitless = parse_point_table(to_tidy_csv(recording), "walk.csv");
  EXPECT_EQ(unitless.positions, recording.positions);
  EXPECT_EQ(unitless.metres_per_unit, 0.0);
  const std::string side = tidy_csv_sidecar(recording);
  expect_words(side, "\"frames_per_second\": 59.94");
  expect_words(side, "a, \\\"b\\\"; 'c'");
}

/// Reads or refuses; anything else is a failure of the test.
void read_anything(const std::string& text) {
  for (const ReadOptions& options : {ReadOptions{}, at_rate(50)}) {
    try {
      const PointRecording recording = parse_point_table(text, "walk.csv", options);
      ASSERT_EQ(recording.positions.size(), recording.seen.size());
      ASSERT_GT(recording.frame_count(), 0);
      ASSERT_EQ(recording.positions.size() % recording.points.size(), 0u);
      for (const Vec3& position : recording.positions) ASSERT_TRUE(position.allFinite());
    } catch (const Error&) {
    }
  }
}

TEST(PointTable, DamagedFilesAreReadOrRefused) {
  const std::string texts[] = {
      wide(underscore, ';', ','),
      "Format Version,1.23,Export Frame Rate,120.0,Length Units,Meters\n,,Marker,Marker,Marker\n"
      ",,a,a,a\n,,Position,Position,Position\nFrame,Time,X,Y,Z\n0,0.0,1,2,3\n1,0.1,1,2,3\n",
      "NO_OF_FRAMES\t2\nFREQUENCY\t200\nMARKER_NAMES\ta\n1.0\t2.0\t3.0\n1.0\t2.0\t3.0\n",
      "frame,person,point,x,y,z\n1,A,\"a\",1,2,3\n2,B,a,1,2,3\n",
      "Trajectories\n100\n,,P:LASI,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n5,0,1,2,3\n"};
  std::mt19937 random(38);
  for (const std::string& text : texts) {
    for (std::size_t length = 0; length < text.size(); ++length)
      read_anything(text.substr(0, length));
    for (int i = 0; i < 200; ++i) {
      std::string changed = text;
      for (int k = 0; k < 3; ++k)
        changed[random() % changed.size()] = ",;\t\"\n#x1.-e9 \r\xff"[random() % 16];
      read_anything(changed);
    }
  }
}

}  // namespace
}  // namespace mien::motion
