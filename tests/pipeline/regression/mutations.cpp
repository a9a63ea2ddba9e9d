#include "pipeline/regression/mutations.h"

#include <numbers>

#include "motion/skeleton/body.h"
#include "motion/skeleton/mirror.h"

namespace mien::test {

namespace {

using motion::BodyJoint;
using nlohmann::json;
using pipeline::Cause;
using pipeline::Verdict;

constexpr double radians = std::numbers::pi / 180.0;

Mutation of_file(const std::string& name, const std::function<void(motion::Recording&)>& change) {
  return {"walk.bvh: " + name,
          "file",
          Cause::motion,
          "clip content",
          [=](ChangedStudy& study) { study.change_motion(change); },
          Verdict::differs};
}

Mutation turned(BodyJoint joint, const motion::Vec3& axis, double degrees) {
  return of_file(std::string(motion::name_of(joint)) + " turned", [=](motion::Recording& walk) {
    const motion::Quat turn(Eigen::AngleAxisd(degrees * radians, axis));
    for (motion::Pose& pose : walk.poses) {
      auto& rotation = pose.rotations[static_cast<std::size_t>(joint)];
      rotation = rotation * turn;
    }
  });
}

/// The pelvis glides aside, so that whatever stands does too.
void slide(motion::Recording& walk, double metres) {
  const std::size_t until = walk.poses.size() / 4;
  for (std::size_t f = 0; f < walk.poses.size(); ++f)
    walk.poses[f].root_position.x() +=
        metres * std::min(1.0, static_cast<double>(f) / static_cast<double>(until));
}

void exchange_sides(motion::Recording& walk) {
  for (motion::Pose& pose : walk.poses) pose = motion::mirrored(pose);
}

/// The merge of a patch into a stimulus.
Mutation of_stimulus(const std::string& id, Cause cause, const std::string& patch,
                     const std::string& root, std::optional<Verdict> verdict = {}) {
  return {id + ": " + patch,
          id,
          cause,
          root,
          [=](ChangedStudy& study) { study.stimulus(id).merge_patch(json::parse(patch)); },
          verdict};
}

Mutation of_study(const std::string& id, Cause cause, const std::string& patch,
                  const std::string& root, std::optional<Verdict> verdict = {}) {
  return {id + " of a study with " + patch,
          id,
          cause,
          root,
          [=](ChangedStudy& study) { study.manifest.merge_patch(json::parse(patch)); },
          verdict};
}

Mutation of_text(const std::string& id, const std::string& file, const std::string& from,
                 const std::string& to, const std::string& root) {
  return {file + ": " + from + " → " + to,
          id,
          Cause::scene,
          root,
          [=](ChangedStudy& study) { study.change_text(file, from, to); },
          Verdict::differs};
}

}  // namespace

std::vector<Mutation> motion_mutations() {
  const motion::Vec3 x = motion::Vec3::UnitX(), y = motion::Vec3::UnitY(),
                     z = motion::Vec3::UnitZ();
  std::vector<Mutation> all = {
      turned(motion::LeftElbow, y, 1.0),
      turned(motion::RightKnee, x, 1.0),
      turned(motion::Chest, z, 1.0),
      turned(motion::Neck, x, -1.0),
      turned(motion::RightHip, z, 1.0),
      turned(motion::LeftAnkle, x, 1.0),
      turned(motion::LeftElbow, x, 10.0),     // a twist of the forearm, which lies along x
      turned(motion::RightShoulder, x, 5.0),  // and of the arm
      turned(motion::LeftHip, y, 5.0),        // of the thigh
      of_file("one frame later",
              [](motion::Recording& walk) {
                walk.poses.insert(walk.poses.begin(), walk.poses.front());
                walk.poses.pop_back();
              }),
      of_file("a frame dropped",
              [](motion::Recording& walk) {
                walk.poses.erase(walk.poses.begin() + static_cast<int>(walk.poses.size()) / 2);
              }),
      of_file("a foot that slides", [](motion::Recording& walk) { slide(walk, 0.005); }),
      of_file("left and right exchanged", exchange_sides),
      of_file("another frame rate", [](motion::Recording& walk) { walk.frames_per_second *= 0.9; }),
      of_stimulus("blend", Cause::motion, R"({"weights": {"normal": 0.61, "proud": 0.39}})",
                  "weights", Verdict::differs),
      of_stimulus("blend", Cause::motion, R"({"weights": {"proud": 0.41}})", "weights.proud",
                  Verdict::differs),
      of_stimulus("blend", Cause::motion, R"({"weights": {"proud": null, "tired": 0.4}})",
                  "weights.tired", Verdict::differs),
      of_stimulus("blend", Cause::motion, R"({"output": {"cycles": 2}})", "output.cycles",
                  Verdict::differs),
      of_stimulus("blend", Cause::motion, R"({"output": {"fps": 12}})", "output.fps",
                  Verdict::differs),
      of_stimulus("blend", Cause::motion, R"({"output": {"in_place": true}})", "output.in_place",
                  Verdict::differs),
      of_stimulus("blend", Cause::motion, R"({"interpolation": {"foot_lock": false}})",
                  "interpolation.foot_lock"),
      of_stimulus("blend", Cause::motion,
                  R"({"interpolation": {"rotations": "direction-vectors"}})",
                  "interpolation.rotations"),
      of_stimulus("wish", Cause::motion, R"({"adjectives": {"quickness": 0.62}})",
                  "adjectives.quickness", Verdict::differs),
      of_stimulus("wish", Cause::motion, R"({"interpolation": {"method": "knn"}})",
                  "interpolation.method", Verdict::differs),
      of_stimulus("wish", Cause::motion, R"({"interpolation": {"method": "inverse-distance"}})",
                  "interpolation.method", Verdict::differs),
      of_study("wish", Cause::motion, R"({"examples": {"raters": 7}})", "examples.raters"),
      of_stimulus("styled", Cause::motion, R"({"modify": {"emotion": "sad", "strength": 0.55}})",
                  "modify", Verdict::differs),
      of_stimulus("styled", Cause::motion, R"({"modify": {"emotion": "angry", "strength": 0.5}})",
                  "modify", Verdict::differs),
      of_study("styled", Cause::motion, R"({"recipes": "fig29"})", "recipes", Verdict::differs),
  };
  all.push_back({"an example of the folder is another", "blend", Cause::motion, "examples content",
                 [](ChangedStudy& study) {
                   std::filesystem::copy_file(study.folder / "walks" / "tired.bvh",
                                              study.folder / "walks" / "proud.bvh",
                                              std::filesystem::copy_options::overwrite_existing);
                 },
                 Verdict::differs});
  return all;
}

std::vector<Mutation> scene_mutations() {
  return {
      // 10 cm beside its place, of a light 4 m away
      of_text("tinted", "my.set.yaml", "azimuth: -28", "azimuth: -29.44", "azimuth"),
      of_text("tinted", "my.set.yaml", "distance: 4,", "distance: 4.1,", "distance"),
      of_text("tinted", "my.set.yaml", "\"#c08040\"", "\"#c28242\"", "ground"),
      of_text("tinted", "my.set.yaml", "\"#d2d3d3\"", "\"#d4d5d5\"", "background"),
      of_text("tinted", "my.set.yaml", "[0.3, 0.3, 0.3]", "[0.33, 0.3, 0.3]", "sky.zenith"),
      {"another texture", "someone", Cause::scene, "look.figure content",
       [](ChangedStudy& study) { write_texture(study.folder, 90); }, Verdict::differs},
      of_text("someone", "someone.gltf", "[0.5,1.0,1.0,1.0]", "[0.7,1.0,1.0,1.0]",
              "look.figure content"),
      of_stimulus("blend", Cause::scene, R"({"look": {"camera": "front"}})", "look.camera",
                  Verdict::differs),
      of_stimulus("blend", Cause::scene, R"({"look": {"camera": {"view": "side"}}})", "look.camera",
                  Verdict::differs),
      of_stimulus("blend", Cause::scene,
                  R"({"look": {"camera": {"view": "three-quarter", "fov": 31}}})",
                  "look.camera.fov"),
      of_stimulus("tinted", Cause::scene,
                  R"({"look": {"camera": {"position": [3, 1.2, 3], "target": [0, 1, 0]}}})",
                  "look.camera", Verdict::differs),
      of_stimulus("tinted", Cause::scene,
                  R"({"look": {"camera": {"position": [-3, 1.2, 3], "target": [0, 1, 0]}}})",
                  "look.camera", Verdict::differs),
      of_stimulus("blend", Cause::scene, R"({"look": {"scene": "corridor"}})", "look.scene",
                  Verdict::differs),
      of_stimulus("styled", Cause::scene, R"({"look": {"figure": "mannequin"}})", "look.figure",
                  Verdict::differs),
      of_stimulus("styled", Cause::scene,
                  R"({"look": {"figure": {"point-light": {}}, "scene": "void"}})", "look",
                  Verdict::differs),
      of_stimulus("blend", Cause::scene, R"({"output": {"size": [112, 54]}})", "output.size",
                  Verdict::differs),
      of_stimulus("blend", Cause::scene, R"({"output": {"scale": 0.5}})", "output.scale",
                  Verdict::differs),
      of_stimulus("blend", Cause::scene, R"({"output": {"crop": [8, 0, 80, 54]}})", "output.crop",
                  Verdict::differs),
      of_study("tinted", Cause::scene, R"({"equalize": ["luminance"]})", "equalize",
               Verdict::differs),
  };
}

std::vector<Mutation> drawing_mutations() {
  std::vector<Mutation> all = {
      of_stimulus("blend", Cause::drawing, R"({"output": {"quality": "standard"}})",
                  "output.quality"),
      of_stimulus("file", Cause::drawing, R"({"output": {"shutter": 270}})", "output.shutter"),
  };
  for (const int seed : {4, 5, 99, 1234})
    all.push_back(of_study("tinted", Cause::drawing, R"({"seed": )" + std::to_string(seed) + "}",
                           "seed", Verdict::alike));
  return all;
}

std::vector<Mutation> all_mutations() {
  std::vector<Mutation> all;
  for (const auto& some : {motion_mutations(), scene_mutations(), drawing_mutations(),
                           program_mutations(), video_mutations()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace mien::test
