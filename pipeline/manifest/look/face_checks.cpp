#include "pipeline/manifest/look/face_checks.h"

#include <variant>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "scenes/character/character_face.h"
#include "scenes/character/face_animation.h"

namespace mien::pipeline {

namespace {

void check_weights(const scenes::FaceWeights& weights, const std::string& path, FaultList& list,
                   const scenes::FaceControls& controls) {
  const std::vector<std::string> names = scenes::face_names(controls);
  for (const auto& [name, weight] : weights) {
    if (scenes::control_named(controls, name) != nullptr) continue;
    list.add_at_key(member_path(path, name),
                    "the character's face has no " + motion::in_quotes(name),
                    motion::did_you_mean(name, names));
  }
}

/// What stands beside `file`, or without it.
void check_keys(const scenes::Face& face, const std::string& path, FaultList& list) {
  const bool has_options = !face.take.empty() || face.start_s != 0.0 || face.frames_per_second;
  if (face.file.empty() && has_options)
    list.add(path, "take, start and fps are of a file of weights, which is missing",
             "add file, or omit them");
  if (face.file.empty() || face.weights.empty()) return;
  const std::vector<std::string> options = {"file", "take", "start", "fps"};
  for (const auto& [name, weight] : face.weights)
    list.add_at_key(member_path(path, name), "a file already gives the weights",
                    motion::nearest_word(name, options) ? motion::did_you_mean(name, options)
                                                        : "omit it, or omit file");
}

void check_options(const scenes::Face& face, const std::string& path, FaultList& list) {
  const bool is_table = !scenes::is_gltf_file(face.file);
  if (is_table && !face.take.empty())
    list.add(member_path(path, "take"), "only glTF files have takes", "omit take");
  if (!is_table && face.frames_per_second)
    list.add(member_path(path, "fps"), "the times of a glTF file are in seconds", "omit fps");
}

void check_file(const scenes::Face& face, const std::string& path, FaultList& list,
                const scenes::FaceControls& controls) {
  const std::string at = member_path(path, "file");
  list.check_file(at, face.file,
                  "a table of weights (.csv, .tsv), a glTF file, or an .npz file of SMPL-X",
                  motion::max_table_bytes);
  if (!motion::read_error(face.file, motion::max_table_bytes).empty()) return;
  try {
    const motion::FaceTrack track = scenes::read_face_track(face);
    if (scenes::unknown_names(track, controls).size() < track.size()) return;
    list.add(at, "none of its names is one of the character's face",
             "rename its columns to " + motion::listed(scenes::face_names(controls)));
  } catch (const Error& wrong) {
    list.add(at, wrong.what(), "");
  }
}

}  // namespace

void check_face(const Look& look, const std::string& path, FaultList& list,
                const CheckedFiles& characters) {
  const std::string own = member_path(path, "face");
  check_keys(look.face, own, list);
  if (look.face.is_neutral()) return;
  const std::filesystem::path* character = scenes::file_of(look.figure);
  if (character == nullptr) {
    list.add(list.was_given(own) ? own : member_path(path, "figure"),
             "the figure " + motion::in_quotes(scenes::kind_of(look.figure).name) + " has no face",
             "use the figure of a character's file, or face: neutral");
    return;
  }
  const auto checked = characters.find(*character);
  if (checked == characters.end() || look.face.is_hidden) return;
  if (checked->second.controls.empty()) {
    list.add(own, "the character has no morph targets, by which its face could move",
             "export it with its morph targets, or omit face");
    return;
  }
  if (look.face.file.empty()) return check_weights(look.face.weights, own, list, checked->second);
  check_options(look.face, own, list);
  check_file(look.face, own, list, checked->second);
}

}  // namespace mien::pipeline
