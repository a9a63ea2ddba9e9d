// Tables of facial weights: times and their resampling against curves, columns, and bad input.

#include "motion/formats/face/face_table.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "motion/text/excerpt.h"

namespace mien::motion {
namespace {

FaceTrack parsed_table(const std::string& text, std::optional<double> rate = std::nullopt) {
  return parse_face_table(text, "face.csv", rate);
}

std::string refused_table(const std::string& text, std::optional<double> rate = std::nullopt) {
  return mien::test::refusal_of([&] { parsed_table(text, rate); });
}

TEST(AFaceTable, IsResampledLinearlyBetweenItsRows) {
  std::string text = "time,jawOpen,eyeBlinkLeft\n";
  const auto jaw = [](double t) { return 0.5 + 0.5 * std::sin(t); };
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i;
    text += std::to_string(t) + "," + std::to_string(jaw(t)) + "," + std::to_string(t / 5.0) + "\n";
  }
  const FaceTrack track = parsed_table(text);
  ASSERT_EQ(track.size(), 2u);
  EXPECT_EQ(track[0].name, "jawOpen");
  EXPECT_EQ(track[1].name, "eyeBlinkLeft");
  for (double t = 0.003; t < 5.0; t += 0.0177) {
    // The error of linear interpolation is at most a step's square times the curvature / 8.
    EXPECT_NEAR(weight_at(track[0], t), jaw(t), 0.01 * 0.01 * 0.5 / 8.0 + 2e-6);
    EXPECT_NEAR(weight_at(track[1], t), t / 5.0, 1e-6);
  }
  EXPECT_DOUBLE_EQ(weight_at(track[1], -3.0), 0.0);
  EXPECT_DOUBLE_EQ(weight_at(track[1], 99.0), 1.0);
}

TEST(AFaceTable, BeginsAtItsFirstRow) {
  const FaceTrack track = parsed_table("jawOpen;time_s\n0;100.5\n1;101.5\n");
  EXPECT_EQ(track[0].times, (std::vector<double>{0.0, 1.0}));
}

TEST(AFaceTable, CountsFramesAtTheGivenRate) {
  const FaceTrack track = parsed_table("frame,jawOpen\n10,0\n20,0.5\n25,1\n", 50.0);
  EXPECT_EQ(track[0].times, (std::vector<double>{0.0, 0.2, 0.3}));
  const std::string said = refused_table("frame,jawOpen\n10,0\n");
  EXPECT_NE(said.find("face.csv:1:1: "), std::string::npos) << said;
  EXPECT_NE(said.find("fps"), std::string::npos) << said;
}

/// As Live Link Face writes them.
TEST(AFaceTable, ReadsTimecodesAndSkipsAngles) {
  const FaceTrack track = parsed_table(
      "Timecode,BlendshapeCount,EyeBlinkLeft,JawOpen,HeadYaw,LeftEyePitch\n"
      "10:21:42:58.000,61,0.1,0.2,-0.3,-0.2\n"
      "10:21:42:59.500,61,0.2,0.3,-0.3,-0.2\n"
      "10:21:43:01.000,61,0.3,0.4,-0.3,-0.2\n");
  ASSERT_EQ(track.size(), 2u);
  EXPECT_EQ(track[1].name, "JawOpen");
  EXPECT_NEAR(track[0].times[1], 1.5 / 60.0, 1e-9);
  EXPECT_NEAR(track[0].times[2], 3.0 / 60.0, 1e-9);
}

TEST(AFaceTable, FindsTheRateOfTimecodes) {
  std::string text = "Timecode,JawOpen\n";
  for (int frame = 0; frame < 4 * 30; ++frame)
    text += "23:59:" + std::to_string(58 + frame / 30 % 2) + ":" + std::to_string(frame % 30) +
            ",0.5\n";
  // From the third second on it is the next day.
  const std::size_t late = text.find("23:59:58:0,0.5", 40);
  ASSERT_NE(late, std::string::npos);
  std::string after = text.substr(late);
  for (std::size_t at = 0; (at = after.find("23:59:5", at)) != std::string::npos;)
    after.replace(at, 8, after[at + 7] == '8' ? "00:00:00" : "00:00:01");
  const FaceTrack track = parsed_table(text.substr(0, late) + after);
  ASSERT_EQ(track[0].times.size(), 120u);
  for (std::size_t i = 0; i < 120; ++i)
    EXPECT_NEAR(track[0].times[i], static_cast<double>(i) / 30.0, 1e-6);
  EXPECT_NEAR(parsed_table("Timecode,a\n0:0:0:0,0\n0:0:0:12,1\n", 24.0)[0].times[1], 0.5, 1e-12);
}

TEST(AFaceTable, IsRefusedWithThePlaceOfWhatIsWrong) {
  const auto expect = [](const std::string& text, const std::string& place,
                         const std::string& wrong) {
    const std::string said = refused_table(text);
    EXPECT_TRUE(said.starts_with("face.csv:" + place + ": ")) << said;
    EXPECT_NE(said.find(wrong), std::string::npos) << said;
  };
  expect("time,jawOpen\n0,0.5\n1,1.5\n", "3:3", "1.5 is not from 0 to 1");
  expect("time,jawOpen\n0,0.5\n1,-0.1\n", "3:3", "-0.1 is not from 0 to 1");
  expect("time,jawOpen\n0,much\n", "2:3", "\"much\" is not a number");
  expect("time,jawOpen\n0\n", "2:1", "is not a number");
  expect("time,jawOpen\nlate,1\n", "2:1", "the time \"late\" is not a number");
  expect("time,jawOpen\n0,0\n0.1,0\n0.1,0\n", "4:1", "not after that of the row before");
  expect("Timecode,JawOpen\n1:2:3,0\n", "2:1", "is not a timecode");
  expect("when,jawOpen\n0,0\n", "1:1", "no column of times");
  expect("time,frame,jawOpen\n0,0,0\n", "1:6", "a second column of times");
  expect("time,jawOpen,JawOpen\n0,0,0\n", "1:14", "a second column \"JawOpen\"");
  expect("time,HeadYaw\n0,0\n", "1:1", "no columns of weights");
  EXPECT_NE(refused_table("").find("the table is empty"), std::string::npos);
  EXPECT_NE(refused_table("time,jawOpen\n").find("no rows"), std::string::npos);
}

TEST(AFaceTable, MutatedAnyhowIsReadOrRefused) {
  const std::string good =
      "Timecode,BlendshapeCount,JawOpen\n1:02:03:04.5,61,0.25\n1:02:03:05,61,0.5\n";
  const std::string likely = "0123456789:;,.-+eE\n\r\t\" aN\xff\x1b";
  std::mt19937_64 random(3);
  int read = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text = good;
    for (std::size_t change = 0; change <= random() % 3; ++change) {
      const std::size_t at = random() % text.size();
      text.replace(at, random() % 3, 1, likely[random() % likely.size()]);
    }
    try {
      for (const FaceCurve& curve : parsed_table(text)) {
        ASSERT_EQ(curve.times.size(), curve.values.size()) << text;
        EXPECT_EQ(curve.times.front(), 0.0);
        EXPECT_TRUE(std::ranges::is_sorted(curve.times)) << text;
        for (const double weight : curve.values) EXPECT_TRUE(weight >= 0.0 && weight <= 1.0);
      }
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(printable(error.what()), error.what());
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 1800);
}

TEST(AFaceCurve, HoldsStepsAndFollowsSplines) {
  FaceCurve curve{"a", FaceCurve::Interpolation::step, {1.0, 2.0, 3.0}, {0.1, 0.7, 0.3}};
  EXPECT_DOUBLE_EQ(weight_at(curve, 1.99), 0.1);
  EXPECT_DOUBLE_EQ(weight_at(curve, 2.0), 0.7);
  // A cubic is its own Hermite spline: t³ − t, tangents 3t² − 1.
  curve.interpolation = FaceCurve::Interpolation::cubic_spline;
  curve.values.clear();
  for (const double t : curve.times)
    curve.values.insert(curve.values.end(), {3 * t * t - 1, t * t * t - t, 3 * t * t - 1});
  for (double t = 1.0; t <= 3.0; t += 0.0625)
    EXPECT_NEAR(weight_at(curve, t), t * t * t - t, 1e-12);
}

}  // namespace
}  // namespace mien::motion
