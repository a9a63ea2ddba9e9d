#include "pipeline/production/synthesis/durations_task.h"

#include <string>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/clips/durations.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double duration_cost_seconds = 0.001;  // a stimulus whose motion is there

std::string durations_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(durations_form);
  const std::string common = shortest(motions.shortest_seconds());
  for (const Stimulus& stimulus : manifest.stimuli) {
    const motion::Clip own = shown_clip(motions.clip(stimulus.id), stimulus.output);
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
  task.products.push_back({std::string(durations_form.path), {}});
  task.cost_seconds = duration_cost_seconds * static_cast<double>(manifest.stimuli.size());
  task.make = [&manifest, &motions](TaskRun& run) {
    const std::string text = durations_csv(manifest, motions);
    run.store.put(
        run.task.products[0].path, run.keys[0],
        [&](const fs::path& file) { write_file(file, text); },
        [](const fs::path& file) { common_duration_in(file); });
  };
  return task;
}

}  // namespace mien::pipeline
