#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "motion/error.h"
#include "motion/formats/fbx/fbx.h"
#include "motion/formats/fbx/fbx_figure.h"
#include "motion/formats/fbx/fbx_pose.h"
#include "motion/formats/fbx/fbx_scene.h"
#include "motion/formats/fbx/fbx_timing.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/skeleton/settled_offsets.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

/// A take with what it moves.
struct ChosenTake {
  std::optional<FbxTake> take;
  FbxAnimation animation;
};

std::vector<bool> moved_models(const FbxScene& scene, const FbxAnimation& animation) {
  std::vector<bool> moved(scene.models.size(), false);
  for (const FbxTrack& track : animation.tracks) {
    if (moves(animation, track)) moved[static_cast<size_t>(track.model)] = true;
  }
  return moved;
}

ChosenTake chosen_take(const FbxScene& scene, const FbxTake& take) {
  return {take, parse_fbx_animation(scene.document, scene.objects, scene.models, take)};
}

/// The take of that name.
ChosenTake named_take(const FbxScene& scene, const std::string& wanted) {
  const auto found = std::ranges::find(scene.takes, wanted, &FbxTake::name);
  if (found != scene.takes.end()) return chosen_take(scene, *found);
  std::vector<std::string> names;
  for (const FbxTake& take : scene.takes) names.push_back(take.name);
  if (names.empty()) {
    throw Error({scene.document.file}, "there is no animation, and so no take " + in_quotes(wanted),
                "omit the take for the pose of the models");
  }
  throw Error({scene.document.file}, "there is no take " + in_quotes(wanted),
              "it holds " + listed(names) + ": choose one of these");
}

/// Whether an animation moves what the figure is made of: its joints and the models above them, or
/// without a known figure any model.
bool moves_figure(const FbxScene& scene, const FbxAnimation& animation,
                  const std::vector<bool>& is_joint) {
  const std::vector<bool> moved = moved_models(scene, animation);
  const bool has_joints = std::ranges::find(is_joint, true) != is_joint.end();
  std::vector<bool> matters(moved.size(), !has_joints);
  for (auto m = scene.parents_first.rbegin(); m != scene.parents_first.rend(); ++m) {
    const auto index = static_cast<size_t>(*m);
    if (is_joint[index]) matters[index] = true;
    const int parent = scene.models[index].parent;
    if (matters[index] && parent >= 0) matters[static_cast<size_t>(parent)] = true;
    if (matters[index] && moved[index]) return true;
  }
  return false;
}

size_t size_of(const FbxAnimation& animation) {
  size_t size = animation.tracks.size();
  for (const FbxCurve& curve : animation.curves) size += curve.keys.size();
  return size;
}

/// The first take that moves the figure, else the first of all.
ChosenTake first_moving_take(const FbxScene& scene) {
  const std::vector<bool> is_joint =
      fbx_joints(scene, std::vector<bool>(scene.models.size(), false));
  // Takes may share curves; what is read for nothing is bounded.
  size_t left = size_t{1} << 27;
  for (const FbxTake& take : scene.takes) {
    ChosenTake chosen = chosen_take(scene, take);
    if (moves_figure(scene, chosen.animation, is_joint)) return chosen;
    const size_t size = size_of(chosen.animation) + scene.models.size();
    if (size > left) break;
    left -= size;
  }
  return scene.takes.empty() ? ChosenTake{} : chosen_take(scene, scene.takes.front());
}

void note_choice(const FbxScene& scene, const ReadOptions& options, Recording& recording) {
  for (const FbxTake& take : scene.takes) recording.takes.push_back(take.name);
  if (options.take || recording.takes.size() < 2) return;
  recording.notes.push_back("The file holds " + std::to_string(recording.takes.size()) +
                            " motions (" + listed(recording.takes) + "); " +
                            in_quotes(recording.take) + " is used, because no take was chosen.");
}

void note_layers(const FbxAnimation& animation, Recording& recording) {
  const bool is_layered =
      std::ranges::any_of(animation.tracks, [](const FbxTrack& track) { return track.layer > 0; });
  if (!is_layered) return;
  recording.notes.push_back(
      "The motion is blended from several animation layers, whose weights are taken as constant; "
      "to be sure of the result, merge the layers before exporting.");
}

void keep_tracks_of(const FbxScene& scene, const FbxFigure& figure, FbxAnimation& animation) {
  std::vector<bool> counts(scene.models.size(), false);
  for (const int model : figure.joints) counts[static_cast<size_t>(model)] = true;
  for (const int model : figure.above) counts[static_cast<size_t>(model)] = true;
  std::erase_if(animation.tracks,
                [&](const FbxTrack& track) { return !counts[static_cast<size_t>(track.model)]; });
}

/// Without layers, what does not move needs to be set once only.
void keep_moving_tracks(FbxAnimation& animation) {
  if (animation.layers.size() > 1) return;
  std::erase_if(animation.tracks, [&](const FbxTrack& track) { return !moves(animation, track); });
}

std::vector<Pose> sampled(const FbxScene& scene, const FbxFigure& figure, FbxAnimation animation,
                          const FbxTiming& timing) {
  require_reasonable_size({scene.document.file}, figure.joints.size(), timing.frames);
  std::vector<FbxMoving> moving = at_rest(scene);
  apply(animation, scene.models, timing.first, moving);
  keep_moving_tracks(animation);
  std::vector<Pose> poses;
  poses.reserve(timing.frames);
  for (size_t frame = 0; frame < timing.frames; ++frame) {
    apply(animation, scene.models, time_of_frame(timing, frame), moving);
    poses.push_back(fbx_pose(scene, figure, moving));
    if (frame > 0 && has_offsets_of(poses.front(), poses.back())) poses.back().offsets = {};
  }
  return poses;
}

Recording recording_of(const FbxScene& scene, const ReadOptions& options) {
  ChosenTake chosen = options.take ? named_take(scene, *options.take) : first_moving_take(scene);
  Recording recording;
  recording.name = recording_name(scene.document.file);
  recording.format = "fbx";
  if (chosen.take) recording.take = chosen.take->name;
  note_choice(scene, options, recording);
  const std::vector<bool> moved = moved_models(scene, chosen.animation);
  FbxFigure figure = fbx_figure(scene, fbx_joints(scene, moved), options.subject, recording);
  drop_ends(scene, moved, figure);
  require_reasonable_size({scene.document.file}, figure.joints.size(), 1);
  // Figures of one file keep their common time, whichever of them is read.
  const FbxAnimation whole = recording.subjects.empty() ? FbxAnimation{} : chosen.animation;
  keep_tracks_of(scene, figure, chosen.animation);
  note_layers(chosen.animation, recording);
  const FbxTiming timing = fbx_timing(scene, recording.subjects.empty() ? chosen.animation : whole,
                                      chosen.take, options, recording.notes);
  recording.frames_per_second = timing.frames_per_second;
  recording.skeleton = fbx_skeleton(scene, figure, moved);
  recording.poses = sampled(scene, figure, std::move(chosen.animation), timing);
  settle_offsets(recording);
  return recording;
}

}  // namespace

Recording parse_fbx(std::string_view bytes, const std::string& file_name,
                    const ReadOptions& options) {
  return recording_of(parse_fbx_scene(bytes, file_name), options);
}

Recording read_fbx(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string bytes = read_contents(path);
  require_kind(bytes, path.string(), "fbx");
  return parse_fbx(bytes, path.string(), options);
}

}  // namespace mien::motion
