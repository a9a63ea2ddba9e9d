#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/acclaim/acclaim.h"
#include "motion/formats/bvh/bvh.h"
#include "motion/formats/gltf/gltf.h"
#include "motion/refusal.h"
#include "motion/text/excerpt.h"
#include "motion/text/result_file.h"

namespace mien::motion {
namespace {

const std::string bvh_arm =
    "HIERARCHY\nROOT upper\n{\n OFFSET 0 0 0\n CHANNELS 1 Xrotation\n End Site\n {\n  OFFSET 0 1 "
    "0\n "
    "}\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n1\n";
const std::string asf_arm =
    ":units\n length 0.45\n angle deg\n:root\n order TX TY TZ RX RY RZ\n axis XYZ\n position 0 0 "
    "0\n "
    "orientation 0 0 0\n:bonedata\n begin\n name arm\n direction 0 1 0\n length 1\n axis 0 0 0 "
    "XYZ\n "
    "dof rx\n end\n:hierarchy\n begin\n root arm\n end\n";
const std::string amc_arm = ":DEGREES\n1\nroot 0 0 0 0 0 0\narm 1\n";

std::string with(const std::string& text, const std::string& word, const std::string& other) {
  std::string changed = text;
  return changed.replace(changed.find(word), word.size(), other);
}

/// What is said of files in which a word is another one.
std::vector<std::string> refusals_with(const std::string& word) {
  std::vector<std::string> refusals;
  for (const char* place : {"HIERARCHY", "ROOT", "OFFSET", "CHANNELS", "1 Xrot", "Xrotation", "End",
                            "MOTION", "0.01", "\n1\n"})
    refusals.push_back(mien::test::refusal_of(
        [&] { parse_bvh(with(bvh_arm, place, "\n" + word + " "), "a.bvh"); }));
  for (const char* place :
       {":units", "0.45", "deg", "TX", "XYZ", "begin", "0 1 0", "rx", "root arm"})
    refusals.push_back(mien::test::refusal_of([&] {
      parse_amc({amc_arm, "a.amc"}, {with(asf_arm, place, word), "a.asf"}, std::nullopt);
    }));
  for (const char* place : {"1\n", "root", "0 0", "arm"})
    refusals.push_back(mien::test::refusal_of([&] {
      parse_amc({with(amc_arm, place, word), "a.amc"}, {asf_arm, "a.asf"}, std::nullopt);
    }));
  return refusals;
}

TEST(HostileText, IsQuotedInPartsThatSomebodyReads) {
  parse_bvh(bvh_arm, "a.bvh");
  parse_amc({amc_arm, "a.amc"}, {asf_arm, "a.asf"}, std::nullopt);
  for (const std::string& refusal : refusals_with(std::string(100'000, 'x')))
    EXPECT_LT(refusal.size(), 400u) << refusal;
}

TEST(HostileText, GivesATerminalNoOrders) {
  for (const std::string& refusal : refusals_with("\x1b[2J\x07\u202E\xff"))
    EXPECT_EQ(printable(refusal), refusal);
}

TEST(HostileText, OfAGltfFileIsQuotedInParts) {
  const std::string text =
      R"({"asset":{"version":"2.0"},"nodes":[{}],"buffers":[{"byteLength":8,"uri":")" +
      std::string(100'000, 'x') + "\"}]}";
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "mien_hostile.gltf";
  write_result(file, text);
  const std::string refusal = mien::test::refusal_of([&] { read_gltf(file); });
  EXPECT_LT(refusal.size(), 400u + file.string().size());
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace mien::motion
