#include "pipeline/production/synthesis/motion_task.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "motion/formats/motion_file.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/synthesis/motion_record.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double motion_cost_seconds = 0.05;
constexpr double clip_cost_seconds = 0.01;

/// glTF has times and no rate: where keys lie far apart it is read at another one, and then lasts
/// as long.
bool lasts_as_long(const motion::Recording& read, const motion::Recording& written) {
  const double seconds = (written.frame_count() - 1) / written.frames_per_second;
  const double read_seconds = (read.frame_count() - 1) / read.frames_per_second;
  return std::abs(read_seconds - seconds) < 1.0 / read.frames_per_second;
}

void verify_clip(const fs::path& file, const motion::Recording& written) {
  const motion::Recording read = motion::read_motion(file);
  if (read.frame_count() == written.frame_count()) return;
  if (read.frames_per_second != written.frames_per_second && lasts_as_long(read, written)) return;
  throw std::runtime_error(fmt::format("{}: {} frames instead of {}", file.string(),
                                       read.frame_count(), written.frame_count()));
}

}  // namespace

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
    task.products.push_back({"clips/" + stimulus.id + "." + ending, {}});
  task.cost_seconds = clip_cost_seconds;
  const bool is_cut = equalize.duration;
  if (is_cut) task.inputs.emplace_back(durations_task_id);
  task.make = [&stimulus, is_cut, &motions](TaskRun& run) {
    if (is_cut) know_durations(run.store.folder(), motions);
    const motion::Recording recording = motion::to_recording(motions.shown(stimulus));
    for (std::size_t i = 0; i < run.keys.size(); ++i) {
      run.put(
          i, [&](const fs::path& file) { motion::write_motion(recording, file); },
          [&](const fs::path& file) { verify_clip(file, recording); });
    }
  };
  return task;
}

}  // namespace mien::pipeline
