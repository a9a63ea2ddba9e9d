#include "pipeline/production/run/design_task.h"

#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/report/study_tasks.h"
#include "pipeline/production/run/codebook.h"
#include "pipeline/production/run/stimuli_table.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double cost_seconds = 0.02;

void check_json(const fs::path& file) {
  if (!nlohmann::json::accept(read_file(file)))
    throw std::runtime_error(file.string() + " is incomplete");
}

}  // namespace

Task design_task(const Manifest& manifest, Motions& motions, const Hash& study,
                 const TaskGraph& graph) {
  Task task;
  task.id = task.kind = "design";
  task.determinants.add("study", study);
  for (const Task& other : graph.tasks) {
    if (other.kind == "motion" || other.kind == "clip" || other.kind == "film")
      task.inputs.push_back(other.id);
  }
  task.products = {{std::string(stimuli_form.path), {}},
                   {std::string(warnings_form.path), {}},
                   {"metrics/codebook.json", {}}};
  task.cost_seconds = cost_seconds;
  task.make = [&manifest, &motions](TaskRun& run) {
    const fs::path& folder = run.store.folder();
    run.put_text(0, stimuli_csv(manifest, motions, folder), read_csv);
    run.put_text(1, warnings_csv(manifest, motions, folder), read_csv);
    run.put_text(2, codebook_json(manifest), check_json);
  };
  return task;
}

}  // namespace mien::pipeline
