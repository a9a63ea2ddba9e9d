#include "pipeline/synthesis/durations_task.h"

#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/documents/files.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char record_path[] = ".mien/durations.json";
constexpr double duration_cost_seconds = 0.001;  // a stimulus whose motion is there

double shortest_in(const fs::path& record) {
  try {
    return json::parse(read_file(record)).at("shortest_s");
  } catch (const json::exception&) {
    throw std::runtime_error("the record of durations is damaged");
  }
}

}  // namespace

Task durations_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions) {
  Task task;
  task.id = task.kind = durations_task_id;
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("motion", motion_code()).add("pipeline", pipeline_code());
  for (const Stimulus& stimulus : manifest.stimuli) task.inputs.push_back("motion:" + stimulus.id);
  task.products.push_back({record_path, {}});
  task.cost_seconds = duration_cost_seconds * static_cast<double>(manifest.stimuli.size());
  task.make = [&motions](TaskRun& run) {
    const std::string text = json{{"shortest_s", motions.shortest_seconds()}}.dump() + "\n";
    run.store.put(
        run.task.products[0].path, run.keys[0],
        [&](const fs::path& file) { write_file(file, text); },
        [](const fs::path& file) { shortest_in(file); });
  };
  return task;
}

void know_durations(const fs::path& folder, Motions& motions) {
  motions.know_shortest(shortest_in(folder / record_path));
}

}  // namespace mien::pipeline
