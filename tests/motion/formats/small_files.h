#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "motion/formats/c3d/written_c3d.h"
#include "motion/formats/fbx/fbx_scene_builder.h"
#include "motion/formats/format_checks.h"
#include "motion/formats/mvnx/mvnx_text.h"
#include "motion/formats/reading/read_options.h"
#include "motion/formats/smpl/smpl_files.h"
#include "motion/gltf_text.h"

namespace mien::test {

/// A recording of a few frames, as one file of each format.
struct SmallFile {
  std::string name;   ///< of the file: "walk.bvh"
  std::string bytes;  ///< sound
  /// The same with 10⁹ frames in its words, but not in its bytes; empty if the format states
  /// neither the number of frames nor that or the time of one.
  std::string endless = {};
  std::vector<std::pair<std::string, std::string>> companions = {};  ///< files beside it
  motion::ReadOptions how = {};

  std::filesystem::path write_to(const std::filesystem::path& folder,
                                 const std::string& changed) const {
    for (const auto& [companion, text] : companions)
      std::ofstream(folder / companion, std::ios::binary) << text;
    std::ofstream(folder / name, std::ios::binary) << changed;
    return folder / name;
  }
};

namespace small_files_parts {

inline constexpr char bvh[] =
    "HIERARCHY\nROOT hip\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation "
    "Xrotation Yrotation\n JOINT knee\n {\n  OFFSET 0 -40 0\n  CHANNELS 3 Zrotation Xrotation "
    "Yrotation\n  End Site\n  {\n   OFFSET 0 -40 0\n  }\n }\n}\nMOTION\nFrames: 2\n"
    "Frame Time: 0.01\n0 90 0 0 0 0 0 0 0\n1 90 0 0 5 0 0 10 0\n";

inline constexpr char asf[] =
    ":units\n length 0.45\n angle deg\n:root\n order TX TY TZ RX RY RZ\n axis XYZ\n position 0 0 "
    "0\n orientation 0 0 0\n:bonedata\n begin\n name arm\n direction 0 1 0\n length 1\n axis 0 0 0 "
    "XYZ\n dof rx\n end\n:hierarchy\n begin\n root arm\n end\n";
inline constexpr char amc[] = ":DEGREES\n1\nroot 0 0 0 0 0 0\narm 1\n2\nroot 0 0 0 0 0 0\narm 2\n";

inline constexpr char trc[] =
    "PathFileType\t4\t(X/Y/Z)\twalk.trc\n"
    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
    "100\t100\t2\t2\tmm\n"
    "Frame#\tTime\tLASI\t\t\tRASI\t\t\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
    "\n"
    "1\t0.00\t1\t2\t3\t4.5\t-5\t6e1\n"
    "2\t0.01\t1.5\t2\t3\tnan\tnan\tnan\n";

inline constexpr char csv[] =
    "frame,time_s,LASI_x,LASI_y,LASI_z,RASI_x,RASI_y,RASI_z\n0,0,1,2,3,4,5,6\n1,0.01,1,2,3.5,4,,\n";

inline constexpr char channels[] =
    "name\tcomponent\ttype\ttracked_point\tunits\na_x\tx\tPOS\ta\tm\na_y\ty\tPOS\ta\tm\n"
    "a_z\tz\tPOS\ta\tm\n";

/// An arm of three nodes of which one turns for a second; a document of glTF.
inline std::string gltf(float last_time = 1.0f, const std::string& extension = {}) {
  GltfNumbers numbers;
  const int times = numbers.add({0.0f, last_time}, "SCALAR");
  const int turns = numbers.add({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, "VEC4");
  std::string text =
      gltf_text(numbers,
                R"("nodes":[{"name":"hip","children":[1]},{"name":"spine","translation":[0,0.4,0],)"
                R"("children":[2]},{"name":"head","translation":[0,0.3,0]}])",
                gltf_channel(0, 1, "rotation"), gltf_sampler(times, turns, "LINEAR"));
  if (extension.empty()) return text;
  return text.insert(1, "\"extensions\":{\"" + extension +
                            R"(":{"humanoid":{"humanBones":{"hips":{"node":0},"spine":{"node":1},)"
                            R"("head":{"node":2}}}}},"extensionsUsed":[")" +
                            extension + "\"],");
}

/// The document as a binary file (glTF 2.0, "GLB File Format").
inline std::string glb(std::string json) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
    return bytes;
  };
  return "glTF" + number(2) + number(20 + json.size()) + number(json.size()) + "JSON" + json;
}

inline std::string c3d(bool is_endless) {
  WrittenC3d file;
  file.frames.assign(2, {{1, 2, 3, 0}, {4, 5, 6, 0}});
  if (!is_endless) return file.bytes();
  file.last_frame = 65'535;
  constexpr int high = 1'000'000'000 >> 16;
  constexpr int low = 1'000'000'000 & 65'535;
  file.more = file.group(2, "TRIAL") + file.words(2, "ACTUAL_START_FIELD", {1, 0}) +
              file.words(2, "ACTUAL_END_FIELD", {low, high});
  return file.bytes();
}

inline std::string fbx(double last_time) {
  FbxSceneBuilder arm;
  const std::int64_t upper = arm.model("upper", "LimbNode", 0, {0, 0, 0});
  arm.model("fore", "LimbNode", upper, {0, 200, 0});
  const auto [stack, layer] = arm.take("bend", 0, std::llround(last_time * fbx_second));
  arm.curve(layer, upper, "Lcl Rotation", "d|Z", {{0, last_time}, {0, 90}});
  return arm.binary();
}

inline std::string mvnx() {
  MvnxLook look;
  look.has_segments = false;
  look.has_joints = false;
  look.has_calibration = false;
  motion::Clip clip;
  clip.body = motion::standard_body();
  clip.frames_per_second = 60.0;
  clip.poses.resize(1);
  clip.poses[0].root_position = {0.0, 1.0, 0.0};
  clip.poses[0].rotations.assign(clip.body.joints.size(), motion::Quat::Identity());
  return mvnx_text(clip, look);
}

/// 24 joints of SMPL at rest, as AMASS stores them; `frames` as the header of the array says.
inline std::string npz(const std::string& frames) {
  return npz_file({{"poses", npy_f8("(" + frames + ", 72)", std::vector<double>(72, 0.1)), true},
                   {"trans", npy_f8("(1, 3)", {0, 0, 1})},
                   {"mocap_framerate", npy_f8("()", {120})}});
}

inline std::string npy(const std::string& frames) {
  return npy_f8("(" + frames + ", 2, 3)", {1, 2, 3, 4, 5, 6});
}

inline std::string keypoints(const std::string& last_frame) {
  std::string text = R"({"fps":30,"frames":[)";
  for (const std::string& frame : {std::string("0"), last_frame}) {
    text +=
        std::string(frame == "0" ? "" : ",") + R"({"frame":)" + frame + R"(,"world_landmarks":[)";
    for (const char* name : {"nose", "left_hip", "right_hip"})
      text += std::string(*name == 'n' ? "" : ",") + R"({"name":")" + name +
              R"(","x":0.1,"y":0.2,"z":0.3,"visibility":0.9})";
    text += "]}";
  }
  return text + "]}";
}

}  // namespace small_files_parts

/// At least one file of each format.
inline std::vector<SmallFile> small_files() {
  using namespace small_files_parts;
  motion::ReadOptions two_named;
  two_named.joints = {"a", "b"};
  two_named.frames_per_second = 50.0;
  const std::string arm = gltf();
  const std::string longest = gltf(1e8f);
  std::string tsv = csv;
  for (char& c : tsv) c = c == ',' ? '\t' : c;
  return {
      {"walk.bvh", bvh, replaced(bvh, "Frames: 2", "Frames: 1000000000")},
      {"walk.amc", amc, {}, {{"walk.asf", asf}}},
      {"walk.fbx", fbx(1.0), fbx(2e7)},
      {"walk.gltf", arm, longest},
      {"walk.glb", glb(arm), glb(longest)},
      {"walk.vrma", glb(gltf(1.0f, "VRMC_vrm_animation")), glb(gltf(1e8f, "VRMC_vrm_animation"))},
      {"walk.vrm", glb(gltf(1.0f, "VRMC_vrm")), glb(gltf(1e8f, "VRMC_vrm"))},
      {"walk.mvnx", mvnx()},
      {"walk.c3d", c3d(false), c3d(true)},
      {"walk.trc", trc, replaced(trc, "2\t0.01", "1000000000\t10000000")},
      {"walk.npz", npz("1"), npz("1000000000")},
      {"walk.npy", npy("1"), npy("1000000000"), {}, two_named},
      {"walk.csv", csv, replaced(csv, "\n1,0.01", "\n1000000000,10000000")},
      {"walk.tsv", tsv, replaced(tsv, "\n1\t0.01", "\n1000000000\t10000000")},
      {"sub-1_tracksys-a_motion.tsv",
       "0\t1\t2\n0.5\t1\t2\n",
       {},
       {{"sub-1_tracksys-a_channels.tsv", channels},
        {"sub-1_tracksys-a_motion.json", R"({"SamplingFrequency":60})"}}},
      {"walk.json", keypoints("1"), keypoints("1000000000")},
  };
}

}  // namespace mien::test
