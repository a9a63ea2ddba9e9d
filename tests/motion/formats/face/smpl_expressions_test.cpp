// Coefficients of facial expression in .npz files of SMPL-X.

#include "motion/formats/face/smpl_expressions.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/numpy/npz.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

const std::vector<double> coefficients = {0.0, -1.5, 0.25, 1.0, 2.0, 0.5};

std::string npz_of(std::vector<NamedArray> arrays) { return to_npz(arrays); }

std::string refused_npz(std::vector<NamedArray> arrays) {
  const std::string bytes = npz_of(std::move(arrays));
  return mien::test::refusal_of([&] { parse_smpl_expressions(bytes, "speech.npz", {}); });
}

TEST(SmplExpressions, AreACurveForEachCoefficient) {
  for (const char* name : {"expressions", "expression"}) {
    const std::string bytes =
        npz_of({{name, array_of(coefficients, {2, 3})},
                {"mocap_frame_rate", array_of(std::vector<double>{30.0}, {})}});
    const FaceTrack track = parse_smpl_expressions(bytes, "speech.npz", std::nullopt);
    ASSERT_EQ(track.size(), 3u);
    EXPECT_EQ(track[1].name, "exp1");
    EXPECT_EQ(track[1].values, (std::vector<double>{-1.5, 2.0}));
    EXPECT_NEAR(weight_at(track[1], 0.5 / 30.0), 0.25, 1e-12);
  }
  const std::string unrated = npz_of({{"expressions", array_of(coefficients, {2, 3})}});
  EXPECT_EQ(parse_smpl_expressions(unrated, "speech.npz", 10.0)[0].times,
            (std::vector<double>{0.0, 0.1}));
}

TEST(SmplExpressions, StandBesideTheRotationsOfJawAndEyes) {
  const NamedArray rate = {"mocap_frame_rate", array_of(std::vector<double>{30.0}, {})};
  std::vector<double> poses(std::size_t{2} * 165, 0.0);
  for (std::size_t i = 0; i < 3; ++i) poses[165 + 66 + i] = 0.1 * static_cast<double>(i + 1);
  poses[165 + 72 + 1] = -0.4;
  const auto names_of = [](const FaceTrack& track) {
    std::vector<std::string> names;
    for (const FaceCurve& curve : track) names.push_back(curve.name);
    return names;
  };
  const FaceTrack whole =
      parse_smpl_expressions(npz_of({{"poses", array_of(poses, {2, 165})},
                                     {"expressions", array_of(coefficients, {2, 3})},
                                     rate}),
                             "talk.npz", {});
  // The left eye does not move.
  EXPECT_EQ(names_of(whole),
            (std::vector<std::string>{"exp0", "exp1", "exp2", "jaw_pose_x", "jaw_pose_y",
                                      "jaw_pose_z", "reye_pose_x", "reye_pose_y", "reye_pose_z"}));
  EXPECT_EQ(whole[4].values, (std::vector<double>{0.0, 0.2}));
  EXPECT_EQ(whole[7].values, (std::vector<double>{0.0, -0.4}));
  const FaceTrack parts = parse_smpl_expressions(
      npz_of({{"jaw_pose", array_of(std::vector<double>{0.1, 0.2, 0.3}, {1, 3})},
              {"pose_eye", array_of(std::vector<double>{0, 0, 0, 0.4, 0.5, 0.6}, {1, 6})},
              rate}),
      "talk.npz", {});
  ASSERT_EQ(parts.size(), 6u);
  EXPECT_EQ(parts[2].values.front(), 0.3);
  EXPECT_EQ(parts[3].name, "reye_pose_x");
  EXPECT_EQ(parts[3].values.front(), 0.4);
}

TEST(SmplExpressions, AreRefusedWithTheReason) {
  const NamedArray rate = {"mocap_frame_rate", array_of(std::vector<double>{30.0}, {})};
  EXPECT_NE(refused_npz({rate}).find("neither facial expressions"), std::string::npos);
  EXPECT_NE(refused_npz({{"expressions", array_of(coefficients, {6})}, rate})
                .find("not of frames and up to 1000 coefficients"),
            std::string::npos);
  const std::vector<double> still(165, 0.0);
  EXPECT_NE(refused_npz({{"poses", array_of(still, {1, 165})}, rate}).find("do not move in it"),
            std::string::npos);
  EXPECT_NE(refused_npz({{"jaw_pose", array_of(coefficients, {1, 6})}, rate})
                .find("not of frames and 3 numbers"),
            std::string::npos);
  std::vector<double> broken = coefficients;
  broken[2] = NAN;
  EXPECT_NE(refused_npz({{"expressions", array_of(broken, {2, 3})}, rate}).find("not finite"),
            std::string::npos);
  EXPECT_TRUE(
      refused_npz({{"expressions", array_of(coefficients, {2, 3})}}).starts_with("speech.npz: "));
}

}  // namespace
}  // namespace mien::motion
