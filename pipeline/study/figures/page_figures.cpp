#include "pipeline/study/figures/page_figures.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <system_error>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include "motion/rig/proportions.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/recorded_hands.h"
#include "scenes/character/character_glb.h"
#include "scenes/face/character_face.h"
#include "scenes/face/hidden_face.h"
#include "scenes/mannequin/mannequin.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_characters = 4;
constexpr std::size_t max_figure_files = 8;
constexpr std::size_t max_faces = 8;

/// The options of a mannequin that is shown, if one is.
const scenes::MannequinOptions* mannequin_in(const scenes::Figure& figure) {
  if (const auto* trail = std::get_if<scenes::TrailOptions>(&figure))
    return std::get_if<scenes::MannequinOptions>(&trail->figure);
  return std::get_if<scenes::MannequinOptions>(&figure);
}

/// The face of a character that is shown; neutral for other figures.
scenes::Face face_in(const scenes::Figure& figure) {
  const auto face = []<class Options>(const Options& options) -> scenes::Face {
    if constexpr (std::is_same_v<Options, scenes::CharacterOptions>) return options.face;
    return {};
  };
  const auto* trail = std::get_if<scenes::TrailOptions>(&figure);
  return trail != nullptr ? std::visit(face, trail->figure) : std::visit(face, figure);
}

std::string time_of(const fs::path& file) {
  std::error_code unknown;
  return fmt::format("{}", fs::last_write_time(file, unknown).time_since_epoch().count());
}

std::string key_of(const scenes::Face& face) {
  std::string key;
  for (const auto& [name, weight] : face.weights) key += fmt::format(" {} {}", name, weight);
  if (!face.file.empty())
    key += fmt::format(" {} {} {} {} {}", face.file.string(), time_of(face.file), face.take,
                       face.start_s, face.frames_per_second.value_or(0.0));
  return key;
}

/// Rounds lengths to 0.01 mm, below which bodies share a mannequin.
std::string key_of(const motion::Skeleton& body) {
  std::string key;
  for (const motion::Joint& joint : body.joints) {
    for (const double metres : joint.offset) key += fmt::format("{:.5f} ", metres);
    for (const double metres : joint.tip.value_or(motion::Vec3::Zero()))
      key += fmt::format("{:.5f} ", metres);
  }
  return key;
}

/// Includes the modification time, so that a rewritten file gets another key.
std::string key_of(const fs::path& file, const motion::Skeleton& body) {
  return fmt::format("{} {} {:.5f}", file.string(), time_of(file), motion::leg_length(body));
}

std::string key_of(const scenes::FigureColours& colours) {
  std::string key;
  for (const auto& colour : {colours.middle, colours.left, colours.right})
    for (const float part : colour) key += fmt::format("{} ", part);
  return key;
}

std::string key_of(const FigureRequest& request) {
  const motion::Clip& clip = request.clip;
  if (!motion::is_body(clip.body)) return "";
  if (const auto* mannequin = mannequin_in(request.figure))
    return fmt::format("mannequin {} {} {}{}{}", mannequin->build, mannequin->sex,
                       key_of(request.colours), key_of(clip.body),
                       motion::has_fingers(clip) ? "with fingers" : "");
  const fs::path* file = scenes::file_of(request.figure);
  if (file == nullptr) return "";
  return "character " + key_of(*file, clip.body) +
         (face_in(request.figure).is_hidden ? " hidden" : "");
}

/// A digest of the key that reveals no path.
std::string digest_of(const std::string& key) {
  std::uint64_t digest = 14695981039346656037ull;  // FNV-1a
  for (const char c : key) digest = (digest ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return fmt::format("{:016x}", digest);
}

void put(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> shift & 0xff));
}

/// PageFigure::poses of the joints that `joints_in` places in each pose.
template <class JointsIn>
std::string poses_of(const motion::Clip& clip, const JointsIn& joints_in) {
  std::string positions, rotations;
  for (const motion::Pose& pose : clip.poses) {
    const motion::JointTransforms joints = joints_in(pose);
    for (const motion::Vec3& position : joints.positions)
      for (const double metres : position) put(positions, metres);
    for (const motion::Quat& rotation : joints.rotations)
      for (const double number : rotation.coeffs()) put(rotations, number);
  }
  return positions + rotations;
}

/// `turns` are those of the face in each frame of the film: of the clip's first cycle, if it loops.
std::string rig_poses(const scenes::Character& character, const motion::Clip& clip,
                      const std::vector<scenes::FaceTurns>& turns) {
  std::size_t frame = 0;
  return poses_of(scenes::retargeted_to(character, clip), [&](const motion::Pose& pose) {
    if (turns.empty()) return scenes::rig_pose(character, pose);
    return scenes::rig_pose(character, pose, turns[std::min(frame++, turns.size() - 1)]);
  });
}

/// Of the body and its hands.
std::string handed_poses(const motion::Skeleton& handed, const motion::Clip& clip) {
  return poses_of(clip, [&](const motion::Pose& pose) {
    return motion::world_transforms(handed, motion::with_fingers(pose));
  });
}

std::string mannequin_file(const scenes::MannequinOptions& options, const FigureRequest& request) {
  using scenes::MannequinHands;
  const MannequinHands hands =
      motion::has_fingers(request.clip) ? MannequinHands::fingers : MannequinHands::one_piece;
  return to_glb(scenes::make_mannequin(request.clip.body, options, request.colours,
                                       scenes::MeshDetail::full, hands),
                request.clip.body);
}

/// A hidden face does not move.
std::string character_file(const scenes::Character& character, const scenes::Face& face) {
  if (!face.is_hidden) return to_glb(character);
  scenes::Character hidden = scenes::with_hidden_face(character);
  for (scenes::SkinnedMesh& mesh : hidden.meshes) mesh.morphs.clear();
  return to_glb(hidden);
}

}  // namespace

std::string body_poses(const motion::Clip& clip) {
  return poses_of(
      clip, [&](const motion::Pose& pose) { return motion::world_transforms(clip.body, pose); });
}

PageFigures::CachedCharacter PageFigures::character(const fs::path& file,
                                                    const motion::Skeleton& body) {
  const std::string key = key_of(file, body);
  for (const auto& [cached_key, cached] : characters_)
    if (cached_key == key) return cached;
  characters_.emplace_front(key, std::make_shared<const scenes::Character>(
                                     scenes::scaled_to_body(scenes::read_character(file), body)));
  if (characters_.size() > max_characters) characters_.pop_back();
  return characters_.front().second;
}

const PageFigures::FaceFrames& PageFigures::face(const scenes::Character& character,
                                                 const std::string& character_key,
                                                 const FigureRequest& request) {
  const scenes::Face face = face_in(request.figure);
  static const FaceFrames none;
  if (face.is_hidden || (face.weights.empty() && face.file.empty())) return none;
  const int frames = face.file.empty() ? 1 : request.film_frames;
  const double rate = request.clip.frames_per_second;
  const std::string key = fmt::format("{}{} {} {}", character_key, key_of(face), frames, rate);
  for (const auto& [cached_key, cached] : faces_)
    if (cached_key == key) return cached;
  const scenes::FaceMotion motion(character, face, frames, rate);
  FaceFrames made{.morphs = character.face.morph_count};
  for (int frame = 0; frame < frames; ++frame) {
    for (const double weight : motion.at(frame)) put(made.weights, weight);
    made.turns.push_back(motion.turns_at(frame));
  }
  const auto is_still = [](const scenes::FaceTurns& turns) { return turns == scenes::FaceTurns(); };
  if (std::ranges::all_of(made.turns, is_still)) made.turns.clear();
  faces_.emplace_front(key, std::move(made));
  if (faces_.size() > max_faces) faces_.pop_back();
  return faces_.front().second;
}

PageFigure PageFigures::fitted_figure(const FigureRequest& request) {
  const motion::Clip& clip = request.clip;
  const std::string key = key_of(request);
  PageFigure fitted{.key = key.empty() ? "" : digest_of(key)};
  const fs::path* own = motion::is_body(clip.body) ? scenes::file_of(request.figure) : nullptr;
  if (own != nullptr) {
    const CachedCharacter cached = character(*own, clip.body);
    fitted.joints = cached->rig.size();
    const FaceFrames& shown = face(*cached, key, request);
    fitted.poses = rig_poses(*cached, clip, shown.turns);
    fitted.morphs = shown.morphs;
    fitted.face = shown.weights;
  } else if (motion::is_body(clip.body) && motion::has_fingers(clip)) {
    const motion::Skeleton handed = motion::with_fingers(clip.body);
    fitted.joints = handed.size();
    fitted.has_hands = true;
    fitted.poses = handed_poses(handed, clip);
  }
  return fitted;
}

const std::string& PageFigures::file(const std::string& key, const FigureRequest& request) {
  static const std::string none;
  const std::string own = key_of(request);
  if (own.empty() || digest_of(own) != key) return none;
  for (const auto& [cached_key, file] : files_)
    if (cached_key == key) return file;
  const auto* options = mannequin_in(request.figure);
  files_.emplace_front(
      key, options != nullptr
               ? mannequin_file(*options, request)
               : character_file(*character(*scenes::file_of(request.figure), request.clip.body),
                                face_in(request.figure)));
  if (files_.size() > max_figure_files) files_.pop_back();
  return files_.front().second;
}

}  // namespace mien::pipeline
