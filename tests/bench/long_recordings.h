#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/bvh/bvh.h"
#include "motion/formats/c3d/written_c3d.h"
#include "motion/formats/fbx/fbx_scene_builder.h"
#include "motion/formats/mvnx/mvnx_text.h"
#include "motion/formats/numpy/npy.h"
#include "motion/formats/numpy/npz.h"
#include "motion/formats/table/tidy_csv.h"
#include "motion/formats/trc/trc.h"
#include "motion/math/rotation.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"

namespace mien::bench {

using namespace mien::motion;

/// A slow motion with as many digits as a measured one.
inline double wave(std::size_t frame, std::size_t channel) {
  return std::sin(0.013 * static_cast<double>(frame) * (1.0 + 0.1 * static_cast<double>(channel)) +
                  static_cast<double>(channel));
}

/// Markers in millimetres at 100 Hz.
inline PointRecording long_points(std::size_t points, std::size_t frames) {
  PointRecording recording;
  recording.name = "walk";
  recording.format = "c3d";
  recording.frames_per_second = 100.0;
  recording.unit = "mm";
  recording.metres_per_unit = 0.001;
  for (std::size_t p = 0; p < points; ++p) recording.points.push_back("M" + std::to_string(p));
  for (std::size_t f = 0; f < frames; ++f)
    for (std::size_t p = 0; p < points; ++p)
      recording.positions.emplace_back(1500.0 + 900.0 * wave(f, 3 * p), 400.0 * wave(f, 3 * p + 1),
                                       900.0 + 850.0 * wave(f, 3 * p + 2));
  recording.seen.assign(recording.positions.size(), true);
  return recording;
}

inline std::string long_c3d(bool floats) {
  const std::size_t points = 60;
  const PointRecording recording = long_points(points, 21'000);
  test::WrittenC3d file;
  file.floats = floats;
  file.scale = 0.1;
  file.labels = recording.points;
  for (std::size_t i = 0; i < recording.positions.size(); i += points) {
    auto& frame = file.frames.emplace_back();
    for (std::size_t p = 0; p < points; ++p) {
      const Vec3& at = recording.positions[i + p];
      frame.push_back({at.x(), at.y(), at.z(), 0.5});
    }
  }
  return file.bytes();
}

/// A chain of bones, each with a key in each of its frames: as exporters bake a take.
inline test::FbxSceneBuilder long_fbx(std::size_t frames) {
  constexpr std::size_t bones = 65;
  test::FbxSceneBuilder scene;
  const auto [stack, layer] = scene.take("walk");
  std::int64_t parent = 0;
  for (std::size_t b = 0; b < bones; ++b) {
    parent = scene.model("bone" + std::to_string(b), "LimbNode", b % 13 == 0 ? 0 : parent,
                         {0.0, 10.0, 0.0});
    for (const char* component : {"d|X", "d|Y", "d|Z"}) {
      test::FbxSceneBuilder::Keys keys;
      for (std::size_t f = 0; f < frames; ++f) {
        keys.seconds.push_back(static_cast<double>(f) / 30.0);
        keys.values.push_back(static_cast<float>(
            40.0 * wave(f, 3 * b + static_cast<std::size_t>(component[2] - 'X'))));
      }
      scene.curve(layer, parent, "Lcl Rotation", component, keys);
    }
  }
  return scene;
}

/// A motion of the canonical body, with finite rotations everywhere.
inline Clip long_clip(std::size_t frames) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 60.0;
  for (std::size_t f = 0; f < frames; ++f) {
    Pose pose;
    pose.root_position = Vec3(0.0, 0.95, 0.01 * static_cast<double>(f % 3000));
    for (std::size_t j = 0; j < clip.body.joints.size(); ++j)
      pose.rotations.push_back(exp(Vec3(wave(f, j), 0.4 * wave(f, j + 40), 0.2 * wave(f, j + 80))));
    clip.poses.push_back(std::move(pose));
  }
  return clip;
}

/// In AMASS' layout: 52 joints of SMPL-H.
inline std::string long_npz(std::size_t frames, NpzCompression compression) {
  constexpr std::size_t width = 156;
  std::vector<double> poses, trans;
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t i = 0; i < width; ++i) poses.push_back(0.6 * wave(f, i));
    for (std::size_t i = 0; i < 3; ++i) trans.push_back(wave(f, i));
  }
  const std::vector<NamedArray> arrays = {
      {"poses", array_of(poses, {frames, width})},
      {"trans", array_of(trans, {frames, 3})},
      {"betas", array_of(std::vector<double>(16, 0.0), {16})},
      {"mocap_framerate", array_of(std::vector<double>{120.0}, {})}};
  return to_npz(arrays, compression);
}

/// Frames of 33 landmarks, as scripts of MediaPipe save them.
inline std::string long_keypoints(std::size_t frames) {
  std::string text = R"({"fps":30,"frames":[)";
  for (std::size_t f = 0; f < frames; ++f) {
    text += f == 0 ? R"({"pose_world_landmarks":[)" : R"(,{"pose_world_landmarks":[)";
    for (std::size_t p = 0; p < 33; ++p) {
      const std::string x = std::to_string(wave(f, 3 * p));
      text += (p == 0 ? R"({"x":)" : R"(,{"x":)") + x + R"(,"y":)" +
              std::to_string(wave(f, 3 * p + 1)) + R"(,"z":)" + std::to_string(wave(f, 3 * p + 2)) +
              R"(,"visibility":0.98})";
    }
    text += "]}";
  }
  return text + "]}";
}

/// A file of 20 MB or more, made when it is needed.
struct LongFile {
  std::string_view title;
  std::string_view name;  ///< of the file
  std::string (*bytes)();
  double unpacked = 0.0;  ///< bytes of its arrays if they are deflated and of another size
};

inline constexpr std::size_t fbx_keys = 65 * 3 * 9000;

inline constexpr LongFile long_files[] = {
    {"BVH", "walk.bvh", [] { return to_bvh(to_recording(long_clip(40'000))); }},
    {"C3D of floats", "floats.c3d", [] { return long_c3d(true); }},
    {"C3D of integers", "integers.c3d", [] { return long_c3d(false); }},
    {"FBX, plain arrays", "plain.fbx", [] { return long_fbx(9000).binary(7400, false); }},
    {"FBX, deflated arrays", "deflated.fbx", [] { return long_fbx(9000).binary(7400, true); },
     12.0 * fbx_keys},
    {"FBX as text", "text.fbx", [] { return long_fbx(5000).text(); }},
    {"MVNX", "walk.mvnx", [] { return test::mvnx_text(long_clip(8000)); }},
    {"TRC", "walk.trc", [] { return to_trc(long_points(60, 12'000)); }},
    {"CSV", "walk.csv", [] { return to_tidy_csv(long_points(60, 9000)); }},
    {"keypoints", "walk.json", [] { return long_keypoints(9000); }},
    {"npz, stored", "stored.npz", [] { return long_npz(16'000, NpzCompression::stored); }},
    {"npz, deflated", "deflated.npz", [] { return long_npz(20'000, NpzCompression::deflated); }},
};

}  // namespace mien::bench
