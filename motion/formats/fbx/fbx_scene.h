#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "motion/formats/fbx/fbx_animation.h"
#include "motion/formats/fbx/fbx_document.h"
#include "motion/formats/fbx/fbx_model.h"
#include "motion/formats/fbx/fbx_objects.h"

namespace mien::motion {

/// What the section "GlobalSettings" says.
struct FbxSettings {
  /// UnitScaleFactor / 100; none if it is not stated.
  std::optional<double> stated_metres_per_unit;
  double metres_per_unit = 0.01;   ///< the stated one, or else a centimetre
  double frames_per_second = 0.0;  ///< of TimeMode; 0 if it is not stated
  /// The file's axes in glTF's: +Y up, +Z to the front, +X to the left of someone who looks there.
  /// A mirror image if the file's axes are left-handed.
  Mat3 to_y_up = Mat3::Identity();
};

/// The parts of a file that make up a motion.
struct FbxScene {
  FbxDocument document;
  FbxObjects objects;
  FbxSettings settings;
  std::vector<FbxModel> models;
  std::vector<int> parents_first;  ///< all models, parents before children
  std::vector<FbxTake> takes;
};

/// Throws mien::Error for axes that are not three, and for an unusable unit.
FbxSettings parse_fbx_settings(const FbxDocument& document);

/// Parses a file's models and lists its takes. `bytes` must outlive the scene. Throws mien::Error.
FbxScene parse_fbx_scene(std::string_view bytes, const std::string& file_name);

/// The places of all models in the world of the file.
std::vector<FbxPlace> places_of(const FbxScene& scene, const std::vector<FbxMoving>& moving);

/// All models at rest.
std::vector<FbxMoving> at_rest(const FbxScene& scene);

/// Frames per second of a TimeMode; 0 for modes without one. `custom` is that of mode 14.
double frame_rate_of_time_mode(std::int64_t mode, double custom);

}  // namespace mien::motion
