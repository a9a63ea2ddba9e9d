#include "scenes/character/character_face.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>

#include "motion/error.h"
#include "motion/formats/face/face_table.h"
#include "motion/formats/face/smpl_expressions.h"
#include "motion/text/as_number.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "scenes/character/face_animation.h"
#include "scenes/character/face_joints.h"

namespace mien::scenes {

namespace {

/// "exp7" for "exp007", "exp_7" and "expression7": coefficients of SMPL-X.
std::optional<std::string> expression_name(std::string_view plain) {
  for (const std::string_view word : {"expression", "exp"}) {
    if (!plain.starts_with(word)) continue;
    std::string_view digits = plain.substr(word.size());
    if (digits.starts_with('_')) digits.remove_prefix(1);
    const std::optional<int> number = motion::as_number<int>(digits);
    if (number && *number >= 0) return "exp" + std::to_string(*number);
  }
  return std::nullopt;
}

/// Without regard to case, to how the side is written, and to zeros before the number of a
/// coefficient.
std::string plain_face_name(std::string_view name) {
  std::string plain;
  for (const char c : name) plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (plain.ends_with("_l")) return plain.substr(0, plain.size() - 2) + "left";
  if (plain.ends_with("_r")) return plain.substr(0, plain.size() - 2) + "right";
  return expression_name(plain).value_or(plain);
}

std::string_view after_last_point(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point == std::string_view::npos ? name : name.substr(point + 1);
}

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

std::vector<std::string> face_names(const FaceControls& face) {
  std::vector<std::string> names;
  for (const FaceControl& control : face.controls) {
    if (!control.is_angle && std::ranges::find(names, control.name) == names.end())
      names.push_back(control.name);
  }
  return names;
}

const FaceControl* control_named(const FaceControls& face, std::string_view name) {
  const auto exact = std::ranges::find(face.controls, name, &FaceControl::name);
  if (exact != face.controls.end()) return &*exact;
  const std::string plain = plain_face_name(name);
  for (const bool is_whole : {true, false}) {
    for (const FaceControl& control : face.controls) {
      const std::string_view own =
          is_whole ? std::string_view(control.name) : after_last_point(control.name);
      if (plain_face_name(own) == plain) return &control;
    }
  }
  return nullptr;
}

FacePose face_pose(const Character& character, const FaceWeights& weights) {
  FacePose pose = face_without_weights(character);
  for (const auto& [name, weight] : weights) {
    const FaceControl* control = control_named(character.face, name);
    if (control == nullptr)
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
