#include "pipeline/production/synthesis/durations_task.h"

#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/csv.h"
#include "pipeline/production/clips/durations.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

constexpr double duration_cost_seconds = 0.001;  // a stimulus whose motion is there

std::string durations_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(durations_form);
  const std::string common = shortest(motions.shortest_seconds());
  for (const Stimulus& stimulus : manifest.stimuli) {
    const motion::Clip own = playback_clip(motions.clip(stimulus.id), stimulus.output);
    table.row({stimulus.id, shortest(own.frame_count() / own.frames_per_second), common});
  }
  return table.text();
}

}  // namespace

Task durations_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions) {
  Task task;
  task.id = task.kind = durations_task_id;
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", motion_code());
  for (const Stimulus& stimulus : manifest.stimuli) task.inputs.push_back("motion:" + stimulus.id);
  task.products = {{std::string(durations_form.path), {}}, {duration_record_path, {}}};
  task.cost_seconds = duration_cost_seconds * static_cast<double>(manifest.stimuli.size());
  task.make = [&manifest, &motions](TaskRun& run) {
    run.put_text(0, durations_csv(manifest, motions), read_csv);
    run.put_text(1, nlohmann::json(motions.shortest_seconds()).dump(), recorded_duration);
  };
  return task;
}

}  // namespace mien::pipeline
