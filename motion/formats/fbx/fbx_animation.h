#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/formats/fbx/fbx_curve.h"
#include "motion/formats/fbx/fbx_model.h"
#include "motion/formats/fbx/fbx_objects.h"

namespace mien::motion {

/// A motion of a file: an animation stack, or before version 7000 a take.
struct FbxTake {
  std::string name;        ///< different from all others
  std::uint32_t node = 0;  ///< in the document
  int object = -1;         ///< the animation stack; −1 for a take
  std::int64_t start = 0;  ///< ticks
  std::int64_t stop = 0;   ///< ticks; not after `start` if the file does not say
};

/// One of three vectors of a model over time.
struct FbxTrack {
  enum class Part { translation, rotation, scale };

  int model = 0;
  Part part = Part::translation;
  int layer = 0;
  std::array<int, 3> curves{-1, -1, -1};  ///< indices in the animation; −1: does not move
  std::array<std::optional<double>, 3> constants;  ///< of components without keys
};

/// How an animation layer changes what those below give. The first layer replaces the pose at rest.
struct FbxLayer {
  double weight = 1.0;
  bool is_override = false;  ///< else additive
  bool adds_angles = false;  ///< rotations are added angle by angle, else as rotations
  bool adds_scales = false;  ///< scales are added, else multiplied
};

struct FbxAnimation {
  std::vector<FbxCurve> curves;  ///< with keys
  std::vector<FbxLayer> layers;
  std::vector<FbxTrack> tracks;  ///< by layer
};

/// All motions of a file, in its order. A second one named "Walk" is "Walk 2", one without a name
/// "take 3".
std::vector<FbxTake> fbx_takes(const FbxDocument& document, const FbxObjects& objects);

/// The tracks of a take that move models. Those of muted layers are omitted. Throws mien::Error if
/// a curve is faulty or there are more than 2^26 keys.
FbxAnimation parse_fbx_animation(const FbxDocument& document, const FbxObjects& objects,
                                 const std::vector<FbxModel>& models, const FbxTake& take);

/// Whether a track changes anything over time.
bool moves(const FbxAnimation& animation, const FbxTrack& track);

/// Sets what moves in the models (as many as models, at rest or at another time of the same
/// animation beforehand) to the values at a time.
void apply(const FbxAnimation& animation, const std::vector<FbxModel>& models, std::int64_t time,
           std::vector<FbxMoving>& moving);

}  // namespace mien::motion
