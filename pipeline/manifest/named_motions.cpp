#include "pipeline/manifest/named_motions.h"

#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

void add_pose(const std::string& path, const PoseSource& pose, std::vector<NamedMotion>& motions) {
  if (pose.file.empty()) return;
  motions.push_back({path, "motion", pose.file, read_options(pose.how), pose.frame,
                     member_path(path, "frame"), pose.how.licence, pose.how.source});
}

}  // namespace

std::vector<NamedMotion> named_motions(const Stimulus& stimulus) {
  std::vector<NamedMotion> motions;
  if (stimulus.clip && !stimulus.clip->file.empty()) {
    const ClipSource& clip = *stimulus.clip;
    const std::string path = member_path(stimulus.path, "clip");
    motions.push_back({path, "file", clip.file, read_options(clip.how),
                       clip.frames ? (*clip.frames)[1] : 0, member_path(path, "frames"),
                       clip.how.licence, clip.how.source});
  }
  if (stimulus.walk) {
    const std::string path = member_path(stimulus.path, "path.graph");
    for (std::size_t i = 0; i < stimulus.walk->graph.size(); ++i) {
      const auto& [file, how] = stimulus.walk->graph[i];
      motions.push_back(
          {element_path(path, i), "file", file, read_options(how), 0, "", how.licence, how.source});
    }
  }
  for (const ModificationStep& step : stimulus.modify) {
    if (!step.pose) continue;
    const std::string path = member_path(step.path, step.edit.pose ? "pose" : "emotion");
    add_pose(member_path(path, "neutral"), step.pose->neutral, motions);
    add_pose(member_path(path, "posed"), step.pose->posed, motions);
  }
  for (const Person& person : stimulus.people) {
    for (NamedMotion& motion : named_motions(person.motion)) motions.push_back(std::move(motion));
  }
  return motions;
}

std::string default_take_note(const NamedMotion& motion) {
  if (motion.how.take || !motion::may_hold_takes(motion.file)) return "";
  const motion::Recording recording = motion::read_motion(motion.file, motion.how);
  return recording.takes.size() > 1 ? recording.notes.front() : "";
}

std::string frame_fault(const motion::Recording& recording, int frame) {
  if (frame < recording.frame_count()) return "";
  const std::string take =
      recording.takes.size() > 1 ? "its take " + motion::in_quotes(recording.take) : "it";
  return fmt::format("{} has {} frames, so frame {} does not exist", take, recording.frame_count(),
                     frame);
}

void require_frame(const motion::Recording& recording, int frame,
                   const std::filesystem::path& file) {
  const std::string fault = frame_fault(recording, frame);
  if (fault.empty()) return;
  throw Error(Place{file.string(), 0, 0}, fault,
              fmt::format("name a frame from 0 to {}", recording.frame_count() - 1));
}

}  // namespace mien::pipeline
