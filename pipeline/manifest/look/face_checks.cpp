#include "pipeline/manifest/look/face_checks.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <variant>

#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "motion/text/text_cursor.h"
#include "scenes/face/character_face.h"
#include "scenes/face/face_animation.h"

namespace mien::pipeline {

namespace {

constexpr std::string_view weights_of_a_face =
    "a table of weights (.csv, .tsv), a glTF file, or an .npz file of SMPL-X";

/// The names that controls were given by, so that none is given twice.
class GivenNames {
 public:
  explicit GivenNames(const scenes::FaceControls& controls) : controls_(controls) {}

  bool is_known(const std::string& name) const {
    return scenes::control_named(controls_, name) != nullptr;
  }

  /// Whether it is known and has weights, rather than the angles of a recording.
  bool has_weights(const std::string& name) const {
    const scenes::FaceControl* control = scenes::control_named(controls_, name);
    return control != nullptr && !control->is_angle;
  }

  /// The name by which the control of this one was given before; empty if it was not.
  std::string before(const std::string& name) {
    const auto [known, is_new] = names_.try_emplace(scenes::control_named(controls_, name), name);
    return is_new ? "" : known->second;
  }

 private:
  const scenes::FaceControls& controls_;
  std::map<const scenes::FaceControl*, std::string> names_;
};

void check_weights(const scenes::FaceWeights& weights, const std::string& path, FaultList& list,
                   const scenes::FaceControls& controls) {
  const std::vector<std::string> names = scenes::face_names(controls);
  GivenNames given(controls);
  for (const auto& [name, weight] : weights) {
    const std::string own = member_path(path, name);
    if (!given.has_weights(name)) {
      list.add_at_key(own, "the character's face has no " + motion::in_quotes(name),
                      motion::did_you_mean(name, names));
    } else if (const std::string before = given.before(name); !before.empty()) {
      list.add_at_key(own, "it has a weight already, as " + motion::in_quotes(before),
                      "omit one of the two");
    }
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

/// Whether the file is one of those that a face may be read from, by its ending.
bool is_of_weights(const std::filesystem::path& file) {
  constexpr std::string_view endings[] = {".csv", ".tsv", ".txt", ".npz"};
  const std::string ending = motion::without_compression(file).extension().string();
  return scenes::is_gltf_file(file) ||
         std::ranges::any_of(endings, [&](auto one) { return motion::same_word(one, ending); });
}

void check_names(const motion::FaceTrack& track, const std::string& at, FaultList& list,
                 const scenes::FaceControls& controls) {
  GivenNames given(controls);
  bool is_any_known = false;
  for (const motion::FaceCurve& curve : track) {
    if (!given.is_known(curve.name)) continue;
    is_any_known = true;
    if (const std::string before = given.before(curve.name); !before.empty())
      list.add(at,
               motion::in_quotes(before) + " and " + motion::in_quotes(curve.name) +
                   " are the same part of the character's face",
               "keep one of them");
  }
  if (!is_any_known)
    list.add(at,
             "none of its names is one of the character's face, which has " +
                 motion::listed(scenes::face_names(controls)),
             "rename those of the file");
}

void check_file(const scenes::Face& face, const std::string& path, FaultList& list,
                const scenes::FaceControls& controls) {
  const std::string at = member_path(path, "file");
  list.check_file(at, face.file, std::string(weights_of_a_face), motion::max_table_bytes);
  if (!motion::read_error(face.file, motion::max_table_bytes).empty()) return;
  if (!is_of_weights(face.file)) {
    list.add(at, face.file.string() + " is no file of weights of a face",
             "give " + std::string(weights_of_a_face));
    return;
  }
  try {
    check_names(scenes::read_face_track(face), at, list, controls);
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
    list.add(own,
             "the character has neither morph targets nor joints of jaw or eyes to move its face",
             "export it with its morph targets, or omit face");
    return;
  }
  if (look.face.file.empty()) return check_weights(look.face.weights, own, list, checked->second);
  check_options(look.face, own, list);
  check_file(look.face, own, list, checked->second);
}

}  // namespace mien::pipeline
