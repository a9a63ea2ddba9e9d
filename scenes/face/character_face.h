#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/formats/face/face_track.h"
#include "scenes/character/character.h"
#include "scenes/figures/face.h"

namespace mien::scenes {

/// What the controls of a face make of it.
struct FacePose {
  std::vector<double> morphs;  ///< weights of all morphs (MorphTarget::morph)
  FaceTurns turns;
};

/// The face for weights by name; what several names change is added. Throws mien::Error for a name
/// that the face does not have.
FacePose face_pose(const Character& character, const FaceWeights& weights);

/// The morphs of `face_pose`.
std::vector<double> morph_weights(const Character& character, const FaceWeights& weights);

/// The weights that a file states over time: a glTF file (face_animation.h), an .npz file
/// (smpl_expressions.h) or a table (face_table.h). Throws mien::Error.
motion::FaceTrack read_face_track(const Face& face);

/// The names of a track that the face does not have.
std::vector<std::string> unknown_names(const motion::FaceTrack& track, const FaceControls& face);

/// The weights of all morphs, and the turns of jaw and eyes, in each frame of a film.
class FaceMotion {
 public:
  /// Of a character whose face is as its file has it.
  FaceMotion() = default;
  /// Throws mien::Error for names that the character does not have, if none of a file's names is
  /// one of the character's, and as `read_face_track`.
  FaceMotion(const Character& character, const Face& face, int frames, double frames_per_second);

  /// The weights of morphs; empty: none.
  std::span<const double> at(int frame) const;

  FaceTurns turns_at(int frame) const;

  /// That names of the file are not among those of the character.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  const FacePose* pose_at(int frame) const;  ///< null: as its file has it

  std::vector<FacePose> frames_;  ///< one: the same in all frames
  std::vector<std::string> warnings_;
};

}  // namespace mien::scenes
