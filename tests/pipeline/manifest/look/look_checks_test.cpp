#include "pipeline/manifest/look/look_checks.h"

#include <ostream>
#include <string>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "scenes/character/character.h"

namespace mien::pipeline {
namespace {

/// The faults of a manifest with that look in its fourth line, one a line.
std::string faults_of_look(const std::string& look) {
  const std::string text = "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nlook: {" + look +
                           "}\nstimuli: [{id: a, weights: {normal: 1}}]\n";
  std::string told;
  for (const Fault& fault :
       parse_manifest(text, "m.yaml", [](const std::string&) { return std::nullopt; }).faults)
    told += to_string(fault) + "\n";
  return told;
}

struct Case {
  const char* look;
  const char* fault;
};

void PrintTo(const Case& example, std::ostream* out) { *out << example.look; }

class LookFaults : public testing::TestWithParam<Case> {};

TEST_P(LookFaults, AreToldWithPlaceAndRemedy) {
  EXPECT_EQ(faults_of_look(GetParam().look), GetParam().fault + std::string("\n"));
}

INSTANTIATE_TEST_SUITE_P(
    Table, LookFaults,
    testing::Values(
        Case{"scene: studio, figure: {point-light: {contrast: 0.5}}",
             "m.yaml:4:46: look.figure.point-light.contrast: the set already determines the "
             "background of the dots; omit it, or omit scene"},
        Case{"scene: {set: void, background: \"#404040\"}, figure: {point-light: {polarity: "
             "dark-on-light}}",
             "m.yaml:4:74: look.figure.point-light.polarity: the set already determines the "
             "background of the dots; omit it, or omit scene"},
        Case{"camera: {position: [0, 1, 0], target: [0, 1, 0]}",
             "m.yaml:4:46: look.camera.target: camera position and target coincide; use a target "
             "other than the position"},
        Case{"camera: {position: [0, 5, 0], target: [0, 1, 0]}",
             "m.yaml:4:46: look.camera.target: the camera would look straight up or down; use a "
             "target that is not directly above or below the position"},
        Case{"camera: {path: [{at: 0, position: [0, 1, 4], target: [0, 1, 4]}, {at: 1, position: "
             "[1, 1, 4], target: [0, 1, 0]}]}",
             "m.yaml:4:61: look.camera.path[0].target: camera position and target coincide; use a "
             "target other than the position"},
        Case{"camera: {path: [{at: 1, position: [0, 1, 4], target: [0, 1, 0]}, {at: 1, position: "
             "[1, 1, 4], target: [0, 1, 0]}]}",
             "m.yaml:4:78: look.camera.path[1].at: the times of a path are not in ascending order; "
             "write seconds in ascending order"},
        Case{"camera: {view: front, path: [{at: 0, position: [0, 1, 4], target: [0, 1, 0]}, {at: "
             "1, position: [1, 1, 4], target: [0, 1, 0]}]}",
             "m.yaml:4:36: look.camera.path: the camera path already determines its position; omit "
             "view, position and target"},
        Case{"camera: {position: [0, 1, 4]}",
             "m.yaml:4:16: look.camera: target is missing; give position and target"},
        Case{"camera: {view: side, orthographic: true, stereo: {}}",
             "m.yaml:4:16: look.camera: an orthographic camera has neither a field of view nor "
             "stereo; omit orthographic, or fov and stereo"},
        Case{"camera: {view: front, frame: upper-body, figure_px: 200}",
             "m.yaml:4:37: look.camera.frame: the camera's distance is already determined; omit "
             "frame, or give the camera only a view"},
        Case{"camera: {view: side, fov: 30, screen: {distance_cm: 60, width_cm: 50}}",
             "m.yaml:4:34: look.camera.fov: the screen already determines the field of view; omit "
             "fov or screen"},
        Case{"camera: {view: side, orthographic: true, screen: {distance_cm: 60, width_cm: 50}}",
             "m.yaml:4:57: look.camera.screen: screen requires a perspective camera; omit "
             "orthographic or screen"},
        Case{"figure: {trail: {figure: {character: nobody.glb}}}",
             "m.yaml:4:45: look.figure.trail.figure.character: there is no file nobody.glb; give a "
             "skinned character (.gltf, .glb, .vrm, .fbx); paths are taken from the manifest's "
             "folder"},
        Case{"figure: {trail: {figure: {stick: {}, mannequin: {}}}}",
             "m.yaml:4:33: look.figure.trail.figure: stick and mannequin exclude each other; keep "
             "one of them"},
        Case{"figure: {trail: {figure: {}}}",
             "m.yaml:4:33: look.figure.trail.figure: has none of stick, mannequin, character; give "
             "one of them"},
        Case{"figure: {character: nobody.glb}",
             "m.yaml:4:28: look.figure.character: there is no file nobody.glb; give a skinned "
             "character (.gltf, .glb, .vrm, .fbx); paths are taken from the manifest's folder"},
        Case{"figure: markers",
             "m.yaml:4:16: look.figure: the motion of \"a\" is not a recording, so it has no "
             "markers; show a recording of markers (clip), or another figure, such as point-light"},
        Case{"hands: gloved",
             "m.yaml:4:15: look.hands: \"gloved\" is not one of the choices; use one of auto, "
             "drawn, "
             "hidden"},
        Case{"hands: hidden, figure: {point-light: {joints: [Head, LeftThumbTip]}}",
             "m.yaml:4:54: look.figure.point-light.joints: hidden hands have no fingers for dots; "
             "omit hands: hidden, or the fingers"},
        Case{"figure: {point-light: {joints: [LeftThumTip]}}",
             "m.yaml:4:40: look.figure.point-light.joints[0]: unknown joint \"LeftThumTip\"; did "
             "you mean \"LeftThumbTip\"?"},
        Case{"figure: {point-light: {joints: [head]}}",
             "m.yaml:4:40: look.figure.point-light.joints[0]: unknown joint \"head\"; did you mean "
             "\"Head\"?"}));

TEST(LookChecks, NameTheEndingsOfCharactersAsSchemaAndPageDo) {
  const std::string endings = fmt::format("({})", fmt::join(scenes::character_endings, ", "));
  EXPECT_NE(manifest_schema_text().find(endings), std::string::npos) << endings;
  EXPECT_NE(read_file(MIEN_SOURCE_DIR "/scenes/README.md").find(endings), std::string::npos);
}

TEST(LookChecks, RefuseMarkersOfAMotionThatIsModified) {
  const std::string text =
      "mien: 1\nstudy: s\nstimuli: [{id: a, clip: nobody.bvh, modify: {tempo: 0.8}, look: "
      "{figure: markers}}]\n";
  std::string told;
  for (const Fault& fault :
       parse_manifest(text, "m.yaml", [](const std::string&) { return std::nullopt; }).faults)
    told += to_string(fault) + "\n";
  EXPECT_NE(told.find("stimuli[0].look.figure: the motion of \"a\" is modified, and its markers "
                      "cannot follow; omit modify"),
            std::string::npos)
      << told;
}

TEST(LookChecks, LeaveContrastToDotsBeforeNothing) {
  EXPECT_EQ(faults_of_look("scene: void, figure: {point-light: {contrast: 0.5}}"), "");
  EXPECT_EQ(faults_of_look("figure: {point-light: {contrast: 0.5}}"), "");
  EXPECT_EQ(
      faults_of_look("camera: {view: side, stereo: {}, screen: {distance_cm: 60, width_cm: 50}}"),
      "");
}

}  // namespace
}  // namespace mien::pipeline
