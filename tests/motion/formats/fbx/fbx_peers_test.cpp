// Writes the joints of the real files for tests/peers/compare_with_fbxloader.mjs into the folder
// $MIEN_FBX_PEERS; is skipped without it.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/formats/fbx/fbx.h"
#include "motion/formats/fbx/fbx_scene.h"
#include "motion/skeleton/pose.h"
#include "motion/text/file_contents.h"

#include "real_data.h"

using namespace mien::motion;

TEST(FbxPeers, AreGivenTheJoints) {
  const char* folder = std::getenv("MIEN_FBX_PEERS");
  const auto data = mien::test::real_data();
  if (folder == nullptr || !data) GTEST_SKIP() << "MIEN_FBX_PEERS names no folder";
  for (const auto& entry : std::filesystem::directory_iterator(*data / "recordings/fbx")) {
    if (entry.path().extension() != ".fbx") continue;
    const std::string bytes = read_contents(entry.path());
    const FbxScene scene = parse_fbx_scene(bytes, "peer.fbx");
    int number = 0;
    for (const FbxTake& take : scene.takes) {
      ReadOptions options;
      options.take = take.name;
      Recording recording;
      try {
        recording = parse_fbx(bytes, "peer.fbx", options);
      } catch (const mien::Error&) {
        continue;  // Files without a skeleton.
      }
      const FbxAnimation animation =
          parse_fbx_animation(scene.document, scene.objects, scene.models, take);
      std::int64_t first = std::numeric_limits<std::int64_t>::max();
      for (const FbxCurve& curve : animation.curves) first = std::min(first, curve.keys[0].time);
      std::ofstream out(std::filesystem::path(folder) /
                        (entry.path().stem().string() + "_" + std::to_string(++number) + ".json"));
      out.precision(12);
      out << "{\"file\":\"" << entry.path().string() << "\",\"take\":\"" << take.name
          << "\",\"metres_per_unit\":" << scene.settings.metres_per_unit << ",\"seconds\":[";
      for (int f = 0; f < recording.frame_count(); ++f) {
        const double start = animation.curves.empty()
                                 ? 0.0
                                 : static_cast<double>(std::max(first, take.start)) /
                                       static_cast<double>(fbx_ticks_per_second);
        out << (f ? "," : "") << start + f / recording.frames_per_second;
      }
      out << "],\"joints\":{";
      for (int j = 0; j < recording.skeleton.size(); ++j) {
        out << (j ? "," : "") << "\"" << recording.skeleton.joints[static_cast<size_t>(j)].name
            << "\":[";
        for (int f = 0; f < recording.frame_count(); ++f) {
          const Vec3 at = world_positions(
              recording.skeleton, recording.poses[static_cast<size_t>(f)])[static_cast<size_t>(j)];
          out << (f ? "," : "") << "[" << at.x() << "," << at.y() << "," << at.z() << "]";
        }
        out << "]";
      }
      out << "}}";
    }
  }
}
