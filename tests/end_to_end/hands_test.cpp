#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

using nlohmann::json;

struct FingerPlace {
  const char* name;
  double x, z;  ///< of the knuckle, metres; x outwards
};

constexpr FingerPlace fingers[] = {{"Thumb", 0.03, 0.04},
                                   {"Index", 0.09, 0.022},
                                   {"Middle", 0.09, 0.0},
                                   {"Ring", 0.088, -0.02},
                                   {"Pinky", 0.08, -0.038}};

/// The joints of a hand for the HIERARCHY of BVH, below a wrist.
std::string hand_joints(bool left) {
  const std::string side = left ? "Left" : "Right";
  const std::string sign = left ? "" : "-";
  std::ostringstream text;
  for (const FingerPlace& finger : fingers) {
    for (int segment = 1; segment <= 3; ++segment) {
      text << "JOINT mixamorig:" << side << "Hand" << finger.name << segment << "\n{\nOFFSET "
           << sign << (segment == 1 ? finger.x : 0.03) << " 0 " << (segment == 1 ? finger.z : 0.0)
           << "\nCHANNELS 3 Zrotation Xrotation Yrotation\n";
    }
    text << "End Site\n{\nOFFSET " << sign << "0.02 0 0\n}\n}\n}\n}\n";
  }
  return text.str();
}

/// Numbers of a hand whose joints are all bent by so many degrees.
std::string hand_numbers(bool left, double degrees) {
  std::ostringstream text;
  for (int joint = 0; joint < 15; ++joint) text << ' ' << (left ? -degrees : degrees) << " 0 0";
  return text.str();
}

/// Puts a text after the so-manieth word of a line.
std::string inserted(const std::string& line, int words, const std::string& text) {
  size_t at = 0;
  for (int word = 0; word < words; ++word) at = line.find(' ', at + (word > 0 ? 1 : 0));
  return line.substr(0, at) + text + line.substr(at);
}

/// A motion of the canonical body as mien writes it to BVH, with hands that are bent.
std::string with_hands(const std::string& bvh, double degrees) {
  std::istringstream lines(bvh);
  std::string text, line;
  bool is_motion = false;
  std::string hand;
  while (std::getline(lines, line)) {
    if (line.find("JOINT LeftWrist") != std::string::npos) hand = hand_joints(true);
    if (line.find("JOINT RightWrist") != std::string::npos) hand = hand_joints(false);
    if (line.starts_with("Frame Time")) {
      is_motion = true;
    } else if (is_motion) {
      // Three numbers of the root's position and three of each joint: after wrists 8 and 12.
      line = inserted(line, 3 + 3 * 13, hand_numbers(false, degrees));
      line = inserted(line, 3 + 3 * 9, hand_numbers(true, degrees));
    }
    text += line + "\n";
    if (hand.empty() || line.find("CHANNELS") == std::string::npos) continue;
    text += hand;
    hand.clear();
  }
  return text;
}

class Hands : public testing::Test {
 protected:
  Hands() {
    EXPECT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights",
                        "normal=1", "--cycles", "2", "-o", at("walk.bvh")})
                  .code,
              0);
    const std::string walk = text_of(at("walk.bvh"));
    scratch_.write("bent.bvh", with_hands(walk, 30.0));
    scratch_.write("slight.bvh", with_hands(walk, 12.0));
  }

  std::string at(const std::string& name) const { return (scratch_.path() / name).string(); }
  json info(const std::string& name) const {
    return json::parse(run_mien({"motion", "info", at(name), "--json"}).output);
  }
  json compared(const std::string& target, const std::string& created) const {
    return json::parse(run_mien({"motion", "compare", at(target), at(created), "--json"}).output);
  }

  Scratch scratch_;
};

TEST_F(Hands, AreListedByInfo) {
  const json bent = info("bent.bvh");
  ASSERT_EQ(bent["hands"].size(), 2u);
  EXPECT_EQ(bent["hands"][0]["hand"], "left");
  EXPECT_EQ(bent["hands"][0]["recorded"], true);
  EXPECT_EQ(bent["hands"][0]["joints"].size(), 15u);
  EXPECT_EQ(bent["hands"][1]["joints"][3]["joint"], "RightIndex1");
  EXPECT_EQ(bent["hands"][1]["joints"][3]["from"], "mixamorig:RightHandIndex1");
  EXPECT_TRUE(bent["hands"][1]["missing"].empty());
  EXPECT_NE(run_mien({"motion", "info", at("bent.bvh")})
                .output.find("hands    left (15 finger joints) and right (15 finger joints)\n"),
            std::string::npos);
  EXPECT_TRUE(info("walk.bvh")["hands"].empty());
  EXPECT_EQ(run_mien({"motion", "info", at("walk.bvh")}).output.find("\nhands "),
            std::string::npos);
}

TEST_F(Hands, AreKeptInEveryFormatOfBodies) {
  for (const std::string name : {"body.bvh", "body.glb", "body.npz"}) {
    const Ended converted = run_mien({"motion", "convert", at("bent.bvh"), at(name), "--body"});
    ASSERT_EQ(converted.code, 0) << converted.errors;
    EXPECT_NE(converted.output.find("51 joints"), std::string::npos) << converted.output;
    const json same = compared("bent.bvh", name);
    // Bone lengths are not part of AMASS files; fingers are as long as the body is tall.
    EXPECT_LT(same["hands_m"].get<double>(), name == "body.npz" ? 2e-3 : 1e-5) << name;
    EXPECT_GT(compared("slight.bvh", name)["hands_m"].get<double>(), 0.02) << name;
  }
}

TEST_F(Hands, AreAMeasureOfTheirOwnBesideD) {
  const json other = compared("slight.bvh", "bent.bvh");
  EXPECT_GT(other["hands_m"].get<double>(), 0.02);
  EXPECT_LT(other["D"].get<double>(), 1e-4);
  EXPECT_TRUE(compared("walk.bvh", "bent.bvh")["hands_m"].is_null());
  const Ended text = run_mien({"motion", "compare", at("slight.bvh"), at("bent.bvh")});
  EXPECT_NE(text.output.find("hands    0.0"), std::string::npos) << text.output;
}

TEST_F(Hands, GoThroughAModificationUnchanged) {
  const Ended modified = run_mien({"motion", "modify", at("bent.bvh"), "sad", at("sad.bvh")});
  ASSERT_EQ(modified.code, 0) << modified.errors;
  EXPECT_EQ(info("sad.bvh")["hands"].size(), 2u);
  EXPECT_LT(compared("bent.bvh", "sad.bvh")["hands_m"].get<double>(), 1e-4);
  EXPECT_GT(compared("bent.bvh", "sad.bvh")["D"].get<double>(), 0.005);
}

TEST_F(Hands, ThatAreBentBackwardsAreFoundByLint) {
  scratch_.write("wrong.bvh", with_hands(text_of(at("walk.bvh")), -40.0));
  const Ended found = run_mien({"motion", "lint", at("wrong.bvh"), "--json"});
  EXPECT_NE(found.output.find("finger-limit"), std::string::npos) << found.output;
  EXPECT_NE(found.output.find("LeftIndex2"), std::string::npos) << found.output;
  EXPECT_EQ(run_mien({"motion", "lint", at("bent.bvh"), "--json"}).output.find("finger-limit"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::test
