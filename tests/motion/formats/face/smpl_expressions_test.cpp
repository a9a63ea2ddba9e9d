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

TEST(SmplExpressions, AreRefusedWithTheReason) {
  const NamedArray rate = {"mocap_frame_rate", array_of(std::vector<double>{30.0}, {})};
  EXPECT_NE(refused_npz({rate}).find("no array of facial expressions"), std::string::npos);
  EXPECT_NE(refused_npz({{"expressions", array_of(coefficients, {6})}, rate})
                .find("not of frames and up to 1000 coefficients"),
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
