#include "scenes/face/character_face.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "motion/error.h"
#include "motion/formats/face/face_table.h"
#include "motion/formats/face/smpl_expressions.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "scenes/character/face_joints.h"
#include "scenes/face/face_animation.h"

namespace mien::scenes {

namespace {

void add_weight(const FaceControl& control, double weight, FacePose& pose) {
  if (control.is_binary) weight = weight > 0.5 ? 1.0 : 0.0;
  for (const auto& [morph, share] : control.morphs)
    pose.morphs[static_cast<std::size_t>(morph)] += weight * share;
  for (std::size_t joint = 0; joint < face_joint_count; ++joint)
    pose.turns.joints[joint] += weight * control.turns.joints[joint];
}

FacePose face_without_weights(const Character& character) {
  return {std::vector<double>(static_cast<std::size_t>(character.face.morph_count), 0.0), {}};
}

}  // namespace

FacePose face_pose(const Character& character, const FaceWeights& weights) {
  FacePose pose = face_without_weights(character);
  for (const auto& [name, weight] : weights) {
    const FaceControl* control = control_named(character.face, name);
    if (control == nullptr || control->is_angle)
      throw Error({character.name}, "its face has no " + motion::in_quotes(name),
                  motion::did_you_mean(name, face_names(character.face)));
    add_weight(*control, weight, pose);
  }
  return pose;
}

std::vector<double> morph_weights(const Character& character, const FaceWeights& weights) {
  return face_pose(character, weights).morphs;
}

motion::FaceTrack read_face_track(const Face& face) {
  if (is_gltf_file(face.file)) return read_face_animation(face.file, face.take);
  if (motion::without_compression(face.file).extension() == ".npz")
    return motion::read_smpl_expressions(face.file, face.frames_per_second);
  return motion::read_face_table(face.file, face.frames_per_second);
}

std::vector<std::string> unknown_names(const motion::FaceTrack& track, const FaceControls& face) {
  std::vector<std::string> unknown;
  for (const motion::FaceCurve& curve : track)
    if (control_named(face, curve.name) == nullptr) unknown.push_back(curve.name);
  return unknown;
}

FaceMotion::FaceMotion(const Character& character, const Face& face, int frames,
                       double frames_per_second) {
  if (face.file.empty()) {
    if (!face.weights.empty()) frames_.push_back(face_pose(character, face.weights));
    return;
  }
  const motion::FaceTrack track = read_face_track(face);
  const std::vector<std::string> unknown = unknown_names(track, character.face);
  if (unknown.size() == track.size())
    throw Error({face.file.string()},
                "none of its names is one of the face of " + character.name + ", which has " +
                    motion::listed(face_names(character.face)),
                "rename its columns");
  if (!unknown.empty())
    warnings_.push_back("The face does not have these names of " + face.file.filename().string() +
                        ": " + motion::listed(unknown) + ".");
  for (int frame = 0; frame < frames; ++frame) {
    FacePose pose = face_without_weights(character);
    for (const motion::FaceCurve& curve : track) {
      const FaceControl* control = control_named(character.face, curve.name);
      if (control == nullptr) continue;
      add_weight(*control, weight_at(curve, frame / frames_per_second - face.start_s), pose);
    }
    frames_.push_back(std::move(pose));
  }
}

const FacePose* FaceMotion::pose_at(int frame) const {
  if (frames_.empty()) return nullptr;
  return &frames_[std::min(static_cast<std::size_t>(frame), frames_.size() - 1)];
}

std::span<const double> FaceMotion::at(int frame) const {
  const FacePose* pose = pose_at(frame);
  return pose == nullptr ? std::span<const double>() : pose->morphs;
}

FaceTurns FaceMotion::turns_at(int frame) const {
  const FacePose* pose = pose_at(frame);
  return pose == nullptr ? FaceTurns() : pose->turns;
}

}  // namespace mien::scenes
