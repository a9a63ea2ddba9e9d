#include "pipeline/production/synthesis/motion_task.h"

#include <cmath>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/formats/written_motion.h"
#include "motion/points/joint_points.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/clip_markers.h"
#include "motion/text/result_file.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/recording_files.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/synthesis/motion_record.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double motion_cost_seconds = 0.05;
constexpr double clip_cost_seconds = 0.01;

constexpr Column clip_points_columns[] = {
    {"frame", "", "frame of the motion, counted from 0"},
    {"time_s", "s", "time of the frame"},
    {"point", "", "name of the joint or, of markers to which no body could be fitted, the marker"},
    {"x_m", "m", "position along x, which is horizontal; empty if the marker was not recorded"},
    {"y_m", "m", "height"},
    {"z_m", "m", "position along z, which is horizontal"}};

motion::Recording recording_of(const motion::Clip& clip) {
  motion::Recording recording = motion::to_recording(clip);
  if (const motion::Markers* markers = motion::markers_of(clip)) recording.markers = *markers;
  return recording;
}

/// Frames and their rate, of joints or of points.
struct Timing {
  int frames = 0;
  double frames_per_second = 0.0;
};

/// As it is read again. Of points, what their file may not state is known from what was written.
Timing timing_in(const fs::path& file, const motion::Recording& written) {
  motion::ReadOptions how;
  if (motion::motion_format(file)->holds_points())
    how.frames_per_second = written.frames_per_second;
  if (motion::motion_format(file)->ending == ".npy")
    how.joints = motion::joint_points(written).points;
  const motion::FileContents contents = motion::read_file(file, how);
  if (const auto* points = std::get_if<motion::PointRecording>(&contents))
    return {points->frame_count(), points->frames_per_second};
  const auto& recording = std::get<motion::Recording>(contents);
  return {recording.frame_count(), recording.frames_per_second};
}

/// glTF has times and no rate: where keys lie far apart it is read at another one, and then lasts
/// as long.
bool lasts_as_long(const Timing& read, const motion::Recording& written) {
  const double seconds = (written.frame_count() - 1) / written.frames_per_second;
  const double read_seconds = (read.frames - 1) / read.frames_per_second;
  return std::abs(read_seconds - seconds) < 1.0 / read.frames_per_second;
}

void verify_clip(const fs::path& file, const motion::Recording& written) {
  const Timing read = timing_in(file, written);
  if (read.frames == written.frame_count()) return;
  if (read.frames_per_second != written.frames_per_second && lasts_as_long(read, written)) return;
  throw std::runtime_error(fmt::format("{}: {} frames instead of {}", file.string(), read.frames,
                                       written.frame_count()));
}

void verify_description(const fs::path& file) {
  if (!nlohmann::json::accept(read_file(file)))
    throw std::runtime_error(file.string() + ": is not JSON");
}

/// Path in the store of a stimulus' motion in one format.
fs::path clip_file(const Stimulus& stimulus, const std::string& ending) {
  return "clips/" + stimulus.id + "." + ending;
}

}  // namespace

const TableForm clip_points_form = {"clips/<stimulus>.csv", "frame and joint of the motion",
                                    clip_points_columns};

Task motion_task(const Stimulus& stimulus, const SharedDeterminants& shared, Motions& motions) {
  Task task;
  task.id = "motion:" + stimulus.id;
  task.kind = "motion";
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", motion_code());
  add_motion(task.determinants, stimulus, shared.files);
  if (is_blend(stimulus) || names_examples(stimulus)) {
    task.determinants.add("repertoire", shared.repertoire);
  }
  task.products.push_back({".mien/motions/" + stimulus.id + ".json", {}});
  task.cost_seconds = motion_cost_seconds;
  task.make = [&stimulus, &motions](TaskRun& run) {
    const Synthesis& synthesis = motions.of(stimulus.id);
    const std::string record =
        motion_record(synthesis, playback_clip(synthesis.motion.clip, stimulus.output));
    run.put_text(0, record, [](const fs::path& file) { parse_motion_record(read_file(file)); });
  };
  return task;
}

Task clip_task(const Stimulus& stimulus, const Equalize& equalize, const SharedDeterminants& shared,
               Motions& motions) {
  Task task;
  task.id = "clip:" + stimulus.id;
  task.kind = "clip";
  task.inputs = {"motion:" + stimulus.id};
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", motion_code());
  for (const std::string& ending : stimulus.output.clips)
    for (const fs::path& file : motion::written_files(clip_file(stimulus, ending)))
      task.products.push_back({file.string(), {}});
  task.cost_seconds = clip_cost_seconds;
  const bool is_cut = equalize.duration;
  if (is_cut) task.inputs.emplace_back(durations_task_id);
  task.make = [&stimulus, is_cut, &motions](TaskRun& run) {
    if (is_cut) know_durations(run.store.folder(), motions);
    const motion::Recording recording = recording_of(motions.shown(stimulus));
    std::size_t product = 0;
    for (const std::string& ending : stimulus.output.clips) {
      bool is_companion = false;
      for (const auto& written : motion::motion_files(recording, clip_file(stimulus, ending))) {
        run.put(
            product++, [&](const fs::path& file) { motion::write_in_place(file, written.bytes); },
            [&](const fs::path& file) {
              is_companion ? verify_description(file) : verify_clip(file, recording);
            });
        is_companion = true;
      }
    }
  };
  return task;
}

std::string unwritable_clip(const Stimulus& stimulus, Motions& motions) {
  for (const std::string& ending : stimulus.output.clips) {
    const fs::path file = clip_file(stimulus, ending);
    if (motion::motion_format(file)->is_of_body &&
        !motion::is_body(motions.of(stimulus.id).motion.clip.body))
      return fmt::format("{} cannot hold it: its points could not be fitted to a body", ending);
  }
  return "";
}

}  // namespace mien::pipeline
