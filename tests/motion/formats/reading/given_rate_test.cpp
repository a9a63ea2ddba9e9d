// The frame rate of files of every format: the file's own, or else the given one.

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/motion_format.h"
#include "motion/formats/small_files.h"
#include "motion/refusal.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

using test::replaced;
using test::SmallFile;
namespace parts = test::small_files_parts;

struct RatedFile {
  double rate = 0.0;
  SmallFile stating;  ///< states the rate
  SmallFile silent;   ///< the same without a rate
};

std::string gltf_of_rate(const std::string& document) {
  return replaced(document, R"("animations":[{)",
                  R"("animations":[{"extras":{"framesPerSecond":4},)");
}

RatedFile gltf_file(const std::string& name, const std::string& extension) {
  const std::string document = parts::gltf(1.0f, extension);
  const auto bytes = [&](const std::string& text) {
    return name == "walk.gltf" ? text : parts::glb(text);
  };
  return {4, {name, bytes(gltf_of_rate(document))}, {name, bytes(document)}};
}

std::string fbx_of_rate() {
  test::FbxSceneBuilder arm;
  const std::int64_t upper = arm.model("upper", "LimbNode", 0, {0, 0, 0});
  arm.model("fore", "LimbNode", upper, {0, 200, 0});
  const auto layer = arm.take("bend", 0, test::fbx_second).second;
  arm.curve(layer, upper, "Lcl Rotation", "d|Z", {{0, 1}, {0, 90}});
  arm.settings.children = {arm.setting("TimeMode", 11)};
  return arm.binary();
}

std::string c3d_without_rate() {
  test::WrittenC3d file;
  file.frames.assign(2, {{1, 2, 3, 0}, {4, 5, 6, 0}});
  file.with_point_rate = false;
  file.rate = 0.0;
  return file.bytes();
}

std::string npz_without_rate() {
  using namespace test;
  return npz_file({{"poses", npy_f8("(1, 72)", std::vector<double>(72, 0.1))},
                   {"trans", npy_f8("(1, 3)", {0, 0, 1})}});
}

SmallFile bids(const std::string& sidecar) {
  return {"sub-1_tracksys-a_motion.tsv",
          "0\t1\t2\n0.5\t1\t2\n",
          {},
          {{"sub-1_tracksys-a_channels.tsv", parts::channels},
           {"sub-1_tracksys-a_motion.json", sidecar}}};
}

RatedFile table(const std::string& name, char separator) {
  std::string timed = parts::csv;
  std::string untimed = "frame,a_x,a_y,a_z\n0,1,2,3\n1,1,2,3.5\n";
  for (std::string* const text : {&timed, &untimed}) std::ranges::replace(*text, ',', separator);
  return {100, {name, timed}, {name, untimed}};
}

/// At least one file of each format.
std::vector<RatedFile> rated_files() {
  ReadOptions named;
  named.joints = {"a", "b"};
  const std::string bvh = parts::bvh;
  const std::string amc = parts::amc;
  const std::string trc = parts::trc;
  const std::string array = parts::npy("1");
  const std::string description = R"({"points": ["a", "b"], "frames_per_second": 50, "unit": "m"})";
  const std::string keypoints = parts::keypoints("1");
  const std::string untimed = replaced(replaced(trc, "100\t100\t", "\t\t"), "0.01", "0.00");
  return {
      {100, {"walk.bvh", bvh}, {"walk.bvh", replaced(bvh, "Frame Time: 0.01\n", "")}},
      {100, {"walk.bvh", bvh}, {"walk.bvh", replaced(bvh, "Time: 0.01", "Time: 0")}},
      {60,
       {"walk.amc", ":SAMPLES-PER-SECOND 60\n" + amc, {}, {{"walk.asf", parts::asf}}},
       {"walk.amc", amc, {}, {{"walk.asf", parts::asf}}}},
      {24, {"walk.fbx", fbx_of_rate()}, {"walk.fbx", parts::fbx(1.0)}},
      gltf_file("walk.gltf", ""),
      gltf_file("walk.glb", ""),
      gltf_file("walk.vrma", "VRMC_vrm_animation"),
      gltf_file("walk.vrm", "VRMC_vrm"),
      {60,
       {"walk.mvnx", parts::mvnx()},
       {"walk.mvnx", replaced(parts::mvnx(), "frameRate=\"60\"", "")}},
      {100, {"walk.c3d", parts::c3d(false)}, {"walk.c3d", c3d_without_rate()}},
      {100, {"walk.trc", trc}, {"walk.trc", untimed}},
      {120, {"walk.npz", parts::npz("1")}, {"walk.npz", npz_without_rate()}},
      {50,
       {"walk.npy", array, {}, {{"walk.npy.json", description}}},
       {"walk.npy", array, {}, {}, named}},
      table("walk.csv", ','),
      table("walk.tsv", '\t'),
      {60, bids(R"({"SamplingFrequency":60})"), bids("{}")},
      {30, {"walk.json", keypoints}, {"walk.json", replaced(keypoints, R"("fps":30,)", "")}},
  };
}

struct Read {
  double rate = 0.0;
  std::vector<std::string> notes;
};

Read read_at(const SmallFile& file, std::optional<double> given) {
  const test::TemporaryFolder folder;
  ReadOptions how = file.how;
  how.frames_per_second = given;
  const FileContents contents = read_file(file.write_to(folder.path(), file.bytes), how);
  return std::visit(
      [](const auto& read) {
        return Read{read.frames_per_second, read.notes};
      },
      contents);
}

bool has_note(const Read& read, const std::string& words) {
  return std::ranges::any_of(
      read.notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

constexpr char unused[] = "used instead of the given";

TEST(GivenRates, AreTriedWithEveryFormat) {
  std::set<std::string> endings;
  for (const RatedFile& file : rated_files()) endings.insert(lower_case_ending(file.stating.name));
  for (const MotionFormat& format : motion_formats())
    EXPECT_TRUE(endings.contains(std::string(format.ending))) << format.ending;
}

TEST(GivenRates, DoNotReplaceThoseThatFilesState) {
  for (const RatedFile& file : rated_files()) {
    SCOPED_TRACE(file.stating.name);
    EXPECT_NEAR(read_at(file.stating, {}).rate, file.rate, 1e-6);
    const Read other = read_at(file.stating, 7.0);
    EXPECT_NEAR(other.rate, file.rate, 1e-6);
    EXPECT_TRUE(has_note(other, "The file states " + std::to_string(std::lround(file.rate)) +
                                    " frames per second, which is used instead of the given 7."));
    for (const double same : {file.rate, file.rate * 1.0009}) {
      const Read read = read_at(file.stating, same);
      EXPECT_NEAR(read.rate, file.rate, 1e-6);
      EXPECT_FALSE(has_note(read, unused));
    }
    EXPECT_TRUE(has_note(read_at(file.stating, file.rate * 1.0011), unused));
  }
}

TEST(GivenRates, AreThoseOfFilesThatStateNone) {
  for (const RatedFile& file : rated_files()) {
    SCOPED_TRACE(file.silent.name);
    for (const double rate : {7.0, 55.0}) {
      const Read read = read_at(file.silent, rate);
      EXPECT_EQ(read.rate, rate);
      EXPECT_FALSE(has_note(read, unused));
    }
  }
}

}  // namespace
}  // namespace mien::motion
