#include "pipeline/manifest/look/look_checks.h"

#include <system_error>
#include <variant>

#include <fmt/ranges.h>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/look/face_checks.h"
#include "pipeline/manifest/look/set_file.h"
#include "scenes/character/character.h"
#include "scenes/point_light/dot_joints.h"
#include "scenes/stage/trail_figure.h"

namespace mien::pipeline {

namespace {

void check_dots(const scenes::PointLightOptions& dots, const std::string& path,
                const std::vector<std::string>& joints, FaultList& list) {
  for (std::size_t i = 0; i < dots.joints.size(); ++i) {
    list.check_known_name(element_path(member_path(path, "joints"), i), dots.joints[i], "joint",
                          joints);
  }
  if (dots.scrambled && dots.lifetime > 0) {
    list.add(member_path(path, "lifetime"),
             "scrambled dots are not on limbs, so they cannot have a limited lifetime",
             "omit scrambled or lifetime");
  }
}

void check_markers(const scenes::MarkersOptions& markers, const std::string& path,
                   FaultList& list) {
  check_dots(markers.dots, path, {}, list);
  const std::string pairs = member_path(path, "pairs");
  if (!markers.pairs.empty() && (markers.dots.scrambled || markers.dots.phase_scrambled)) {
    list.add(pairs, "scrambled markers are not on a body, as pairs require",
             "omit scrambled or pairs");
  }
  if (markers.pairs.empty() && markers.dots.lifetime > 0 && !markers.dots.scrambled) {
    list.add(member_path(path, "lifetime"),
             "markers without pairs are not on limbs, as a limited lifetime requires",
             "name the two markers of each limb in pairs, or omit lifetime");
  }
  for (std::size_t i = 0; i < markers.pairs.size(); ++i) {
    if (markers.pairs[i][0] != markers.pairs[i][1]) continue;
    list.add(element_path(pairs, i), "both ends are the same marker", "name two markers");
  }
}

void check_trail(const scenes::TrailOptions& trail, const std::string& path,
                 const std::vector<std::string>& joints, FaultList& list) {
  constexpr int most_poses = 29;  // figures of a picture, less the present pose and the traces
  if (scenes::max_ghosts(trail) > most_poses) {
    list.add(path, "too many poses for one image", "use at most 29 in addition to the present one");
  }
  std::vector<std::string> known = joints;
  if (!known.empty()) known.insert(known.end(), {"feet", "hands", "head", "pelvis"});
  for (std::size_t i = 0; i < trail.traces.size(); ++i) {
    list.check_known_name(element_path(member_path(path, "traces"), i), trail.traces[i], "joint",
                          known);
  }
}

void check_character(const scenes::CharacterOptions& character, const std::string& path,
                     FaultList& list, CheckedFiles& characters) {
  if (characters.contains(character.file)) return;
  list.check_file(
      path, character.file,
      fmt::format("a skinned character ({})", fmt::join(scenes::character_endings, ", ")),
      motion::max_recording_bytes);
  if (!motion::read_error(character.file, motion::max_recording_bytes).empty()) return;
  try {
    characters.emplace(character.file, scenes::read_character(character.file).face);
  } catch (const Error& wrong) {
    list.add(path, wrong.what(), "");
  }
}

/// Contrast is that of dots and background, which a set may have already.
void check_contrast(const Look& look, const std::string& path, FaultList& list) {
  const scenes::PointLightOptions& dots = *scenes::dots_in(look.figure);
  if (look.scene.empty() || !dots.background.empty()) return;
  const bool has_background = !look.background.empty() || look.scene != "void";
  for (const char* key : {"contrast", "polarity"}) {
    const std::string at = member_path(path, key);
    if (!has_background || !list.was_given(at)) continue;
    list.add_at_key(at, "the set already determines the background of the dots",
                    "omit it, or omit scene");
  }
}

void check_figure(const Look& look, const std::string& path, const std::vector<std::string>& joints,
                  FaultList& list, CheckedFiles& characters) {
  if (const auto* character = std::get_if<scenes::CharacterOptions>(&look.figure)) {
    check_character(*character, member_path(path, "character"), list, characters);
  }
  if (const auto* dots = std::get_if<scenes::PointLightOptions>(&look.figure)) {
    const std::string own = member_path(path, "point-light");
    check_dots(*dots, own, joints, list);
    if (look.hands == scenes::Hands::hidden && scenes::has_dots_on_fingers(*dots))
      list.add(member_path(own, "joints"), "hidden hands have no fingers for dots",
               "omit hands: hidden, or the fingers");
  }
  if (const auto* markers = std::get_if<scenes::MarkersOptions>(&look.figure))
    check_markers(*markers, member_path(path, "markers"), list);
  if (scenes::dots_in(look.figure) != nullptr)
    check_contrast(look, member_path(path, scenes::kind_of(look.figure).name), list);
  if (const auto* trail = std::get_if<scenes::TrailOptions>(&look.figure)) {
    if (const auto* character = std::get_if<scenes::CharacterOptions>(&trail->figure)) {
      check_character(*character, member_path(path, "trail.figure.character"), list, characters);
    }
    check_trail(*trail, member_path(path, "trail"), joints, list);
  }
}

/// A camera needs a direction, and an up that is not along it.
void check_axis(const motion::Vec3& position, const motion::Vec3& target, const std::string& path,
                FaultList& list) {
  const motion::Vec3 axis = target - position;
  if (axis.norm() < 1e-6) {
    list.add(path, "camera position and target coincide", "use a target other than the position");
  } else if (axis.cross(motion::Vec3::UnitY()).norm() < 1e-5 * axis.norm()) {
    list.add(path, "the camera would look straight up or down",
             "use a target that is not directly above or below the position");
  }
}

void check_camera(const Look& look, const std::string& path, FaultList& list) {
  const scenes::CameraSettings& camera = look.camera;
  if (camera.position.has_value() != camera.target.has_value()) {
    const std::string missing = camera.position ? "target" : "position";
    list.add(path, missing + " is missing", "give position and target");
  }
  if (camera.position && camera.target) {
    check_axis(*camera.position, *camera.target, member_path(path, "target"), list);
  }
  for (std::size_t i = 0; i < camera.path.size(); ++i) {
    check_axis(camera.path[i].position, camera.path[i].target,
               member_path(element_path(member_path(path, "path"), i), "target"), list);
  }
  if (!camera.path.empty() && (camera.position || list.was_given(member_path(path, "view")))) {
    list.add(member_path(path, "path"), "the camera path already determines its position",
             "omit view, position and target");
  }
  const bool has_own_frame =
      camera.position || !camera.path.empty() || camera.screen || camera.figure_px;
  if (camera.subject != scenes::CameraSubject::whole_body && has_own_frame) {
    list.add(member_path(path, "frame"), "the camera's distance is already determined",
             "omit frame, or give the camera only a view");
  }
  for (std::size_t i = 1; i < camera.path.size(); ++i) {
    if (camera.path[i].seconds > camera.path[i - 1].seconds) continue;
    list.add(member_path(element_path(member_path(path, "path"), i), "at"),
             "the times of a path are not in ascending order", "write seconds in ascending order");
  }
  if (camera.orthographic && (camera.fov_degrees || camera.stereo_separation_m)) {
    list.add(path, "an orthographic camera has neither a field of view nor stereo",
             "omit orthographic, or fov and stereo");
  }
  if (camera.figure_px && (camera.screen || camera.position || !camera.path.empty())) {
    list.add(member_path(path, "figure_px"),
             std::string(camera.screen ? "the screen" : "its position") +
                 " already determines the size of the figure",
             "omit figure_px, or give only a view");
  }
  if (camera.screen && camera.orthographic) {
    list.add(member_path(path, "screen"), "screen requires a perspective camera",
             "omit orthographic or screen");
  }
  if (camera.screen && camera.fov_degrees) {
    list.add(member_path(path, "fov"), "the screen already determines the field of view",
             "omit fov or screen");
  }
}

}  // namespace

std::vector<Fault> resolve_set(Look& look, const std::string& path, const Places& places,
                               ReadSets& sets) {
  const auto fault = [&](const std::string& wrong, std::string remedy) -> std::vector<Fault> {
    const std::string scene = member_path(path, "scene");
    return {{place_of(places, scene), scene, wrong, std::move(remedy)}};
  };
  const std::pair named(scene_of(look), look.scene_file);
  std::error_code unknown;
  if (!look.scene_file.empty() && !std::filesystem::exists(look.scene_file, unknown))
    return fault(motion::in_quotes(look.scene) + " is neither a set nor a file",
                 motion::did_you_mean(look.scene, set_names()));
  try {
    if (!sets.contains(named)) sets.emplace(named, read_set(named.first, named.second));
    look.set = sets.at(named);
  } catch (const Faults& wrong) {
    return wrong.list();
  } catch (const Error& wrong) {
    return fault(wrong.what(), "");
  }
  return {};
}

std::vector<Fault> check_look(const Look& look, const std::string& path, const Places& places,
                              const std::vector<std::string>& joints, CheckedFiles& characters) {
  FaultList list(places);
  check_figure(look, member_path(path, "figure"), joints, list, characters);
  check_face(look, path, list, characters);
  check_camera(look, member_path(path, "camera"), list);
  return list.take();
}

}  // namespace mien::pipeline
