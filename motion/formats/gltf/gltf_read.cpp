#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "motion/formats/gltf/gltf.h"
#include "motion/formats/gltf/gltf_figure.h"
#include "motion/formats/gltf/gltf_library.h"
#include "motion/formats/gltf/gltf_nodes.h"
#include "motion/formats/gltf/gltf_track.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/skeleton/settled_offsets.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

/// Where a node is in the world. `linear` has the scales that `rotation` leaves out.
struct NodeInWorld {
  Vec3 position = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Mat3 linear = Mat3::Identity();
};

NodeInWorld child_of(const NodeInWorld& parent, const NodeTransform& local) {
  return {parent.position + parent.linear * local.translation,
          (parent.rotation * local.rotation).normalized(),
          parent.linear * local.rotation.toRotationMatrix() * local.scale.asDiagonal()};
}

/// The position of `point` in the frame of a node without its scales.
Vec3 seen_from(const NodeInWorld& node, const Vec3& point) {
  return node.rotation.conjugate() * (point - node.position);
}

std::vector<NodeInWorld> in_world(const GltfFigure& figure,
                                  const std::vector<NodeTransform>& nodes) {
  NodeInWorld top;
  for (const int node : figure.above) top = child_of(top, nodes[static_cast<size_t>(node)]);
  std::vector<NodeInWorld> joints;
  joints.reserve(figure.joints.size());
  for (size_t j = 0; j < figure.joints.size(); ++j) {
    const NodeInWorld& parent = j == 0 ? top : joints[static_cast<size_t>(figure.parents[j])];
    joints.push_back(child_of(parent, nodes[static_cast<size_t>(figure.joints[j])]));
  }
  return joints;
}

void require_usable(const GltfFile& file, const Vec3& position) {
  if (!position.allFinite() || position.cwiseAbs().maxCoeff() > 1e9) {
    refuse(file, "a joint is too far away", "check the scales of the nodes");
  }
}

Pose pose_of(const GltfFile& file, const GltfFigure& figure,
             const std::vector<NodeTransform>& nodes) {
  const std::vector<NodeInWorld> joints = in_world(figure, nodes);
  Pose pose;
  pose.root_position = joints.front().position;
  pose.rotations.push_back(joints.front().rotation);
  pose.offsets.push_back(pose.root_position);
  for (size_t j = 1; j < joints.size(); ++j) {
    pose.rotations.push_back(nodes[static_cast<size_t>(figure.joints[j])].rotation);
    const NodeInWorld& parent = joints[static_cast<size_t>(figure.parents[j])];
    pose.offsets.push_back(seen_from(parent, joints[j].position));
  }
  for (const NodeInWorld& joint : joints) require_usable(file, joint.position);
  return pose;
}

Skeleton skeleton_of(const GltfFile& file, const GltfNodes& nodes, const GltfFigure& figure,
                     const std::vector<GltfTrack>& tracks) {
  const std::vector<NodeInWorld> at_rest = in_world(figure, nodes.at_rest);
  const Pose rest = pose_of(file, figure, nodes.at_rest);
  Skeleton skeleton;
  for (size_t j = 0; j < figure.joints.size(); ++j) {
    const int node = figure.joints[j];
    Joint joint;
    joint.name = file.model.nodes[static_cast<size_t>(node)].name;
    if (joint.name.empty()) joint.name = "joint_" + std::to_string(j);
    joint.parent = figure.parents[j];
    joint.offset = rest.offsets[j];
    skeleton.joints.push_back(std::move(joint));
  }
  const std::set<int> joints(figure.joints.begin(), figure.joints.end());
  const std::vector<bool> moved = moved_nodes(nodes, tracks);
  for (size_t j = 0; j < figure.joints.size(); ++j) {
    const int tip = tip_node(file, nodes, moved, figure.joints[j]);
    if (tip < 0 || joints.contains(tip)) continue;
    const NodeInWorld end = child_of(at_rest[j], nodes.at_rest[static_cast<size_t>(tip)]);
    require_usable(file, end.position);
    skeleton.joints[j].tip = seen_from(at_rest[j], end.position);
  }
  return skeleton;
}

std::vector<Pose> sampled(const GltfFile& file, const GltfNodes& nodes, const GltfFigure& figure,
                          const std::vector<GltfTrack>& tracks, const TrackTiming& timing) {
  if (!(timing.last - timing.first <= 3600.0)) {
    refuse(file, "the animation is longer than an hour", "cut the motion into shorter files");
  }
  const size_t frames = frame_count(timing);
  require_reasonable_size({file.name}, figure.joints.size(), frames);
  std::vector<NodeTransform> transforms = nodes.at_rest;
  std::vector<Pose> poses;
  poses.reserve(frames);
  for (size_t f = 0; f < frames; ++f) {
    const double time = seconds_of_frame(timing, f);
    for (const GltfTrack& track : tracks) {
      apply(track, time, transforms[static_cast<size_t>(track.node)]);
    }
    poses.push_back(pose_of(file, figure, transforms));
  }
  return poses;
}

void keep_tracks_of(const GltfFigure& figure, const GltfNodes& nodes,
                    std::vector<GltfTrack>& tracks) {
  std::vector<bool> counts(nodes.parents.size(), false);
  for (const int node : figure.joints) counts[static_cast<size_t>(node)] = true;
  for (const int node : figure.above) counts[static_cast<size_t>(node)] = true;
  std::erase_if(tracks,
                [&](const GltfTrack& track) { return !counts[static_cast<size_t>(track.node)]; });
}

/// The animation of that name, without one the first that moves anything; none when none does.
std::optional<GltfTake> chosen_take(const GltfFile& file, const std::vector<GltfTake>& takes,
                                    const std::optional<std::string>& wanted) {
  if (!wanted) return takes.empty() ? std::nullopt : std::optional(takes.front());
  std::vector<std::string> names;
  for (const GltfTake& take : takes) names.push_back(take.name);
  const auto found = std::ranges::find(takes, *wanted, &GltfTake::name);
  if (found != takes.end()) return *found;
  if (names.empty()) {
    refuse(file, "there is no animation, and so no take " + in_quotes(*wanted),
           "omit the take for the pose of the nodes");
  }
  refuse(file, "there is no take " + in_quotes(*wanted),
         "it holds " + listed(names) + ": choose one of these");
}

void note_choice(Recording& recording, bool was_asked_for) {
  if (was_asked_for || recording.takes.size() < 2) return;
  recording.notes.push_back("The file holds " + std::to_string(recording.takes.size()) +
                            " motions (" + listed(recording.takes) + "); " +
                            in_quotes(recording.take) + " is used, because no take was chosen.");
}

Recording recording_of(const GltfFile& file, const std::optional<std::string>& wanted,
                       const std::optional<std::string>& subject, std::optional<double> rate) {
  const GltfNodes nodes = parse_nodes(file);
  const std::vector<GltfTake> takes = gltf_takes(file);
  const std::optional<GltfTake> take = chosen_take(file, takes, wanted);
  std::vector<GltfTrack> tracks;
  if (take) tracks = parse_tracks(file, take->animation);
  Recording recording;
  recording.name = recording_name(file.name);
  recording.format = "gltf";
  for (const GltfTake& one : takes) recording.takes.push_back(one.name);
  if (take) recording.take = take->name;
  note_choice(recording, wanted.has_value());
  const GltfFigure figure = gltf_figure(file, nodes, tracks, subject, recording);
  require_reasonable_size({file.name}, figure.joints.size(), 1);
  recording.skeleton = skeleton_of(file, nodes, figure, tracks);
  // Figures of one file keep their common time, whichever of them is read.
  std::optional<TrackTiming> common;
  const double stated = take ? stated_frame_rate(file, take->animation) : 0.0;
  const double usual = stated > 0.0 ? stated : rate.value_or(0.0);
  if (!recording.subjects.empty() && !tracks.empty()) common = timing_of(tracks, usual);
  keep_tracks_of(figure, nodes, tracks);
  if (tracks.empty()) {
    recording.frames_per_second = rate.value_or(recording.frames_per_second);
    recording.poses = {pose_of(file, figure, nodes.at_rest)};
  } else {
    const TrackTiming timing = common ? *common : timing_of(tracks, usual);
    recording.frames_per_second = timing.frames_per_second;
    recording.poses = sampled(file, nodes, figure, tracks, timing);
  }
  settle_offsets(recording);
  return recording;
}

}  // namespace

Recording parse_gltf(std::string_view bytes, const std::string& file_name,
                     const std::optional<std::string>& take,
                     const std::optional<std::string>& subject, std::optional<double> rate) {
  return recording_of(parse_gltf_file(bytes, file_name, std::nullopt), take, subject, rate);
}

Recording read_gltf(const std::filesystem::path& path, const std::optional<std::string>& take,
                    const std::optional<std::string>& subject, std::optional<double> rate) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::string bytes = read_contents(path);
  require_kind(bytes, path.string(), "gltf");
  return recording_of(parse_gltf_file(bytes, path.string(), folder), take, subject, rate);
}

}  // namespace mien::motion
