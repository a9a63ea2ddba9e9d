#include "pipeline/production/synthesis/durations_task.h"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/people.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/clips/people_clips.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

constexpr double duration_cost_seconds = 0.001;  // a stimulus whose motion is there

struct FilmDuration {
  std::string stimulus;
  double own_s;
  double common_s;
};

constexpr auto durations_columns = table_of<FilmDuration>(
    "metrics/durations.csv", "stimulus, if duration is equalized",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.stimulus; }},
     {"own_s", "s", "duration of its film before equalizing", [](auto& r) { return r.own_s; }},
     {"duration_s", "s",
      "duration of all films, to the nearest frame: the shortest of those before equalizing",
      [](auto& r) { return r.common_s; }}});

std::string durations_csv(const Manifest& manifest, Motions& motions) {
  std::vector<FilmDuration> rows;
  for (const Stimulus& stimulus : manifest.stimuli) {
    const double own_s = own_frames(stimulus, motions) / stimulus.output.fps;
    rows.push_back({stimulus.id, own_s, motions.shortest_seconds()});
  }
  return durations_columns.of(rows).csv;
}

}  // namespace

const TableForm durations_form = durations_columns.form();

Task durations_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions) {
  Task task;
  task.id = task.kind = durations_task_id;
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", motion_code());
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const Stimulus* motion : motions_in(stimulus))
      task.inputs.push_back("motion:" + motion->id);
    for (const Person& person : stimulus.people)
      task.determinants.add("person of " + stimulus.id, person.name).add("start", person.start);
  }
  task.products = {{std::string(durations_form.path), {}}, {duration_record_path, {}}};
  task.cost_seconds = duration_cost_seconds * static_cast<double>(manifest.stimuli.size());
  task.make = [&manifest, &motions](TaskRun& run) {
    run.put_text(0, durations_csv(manifest, motions), read_csv);
    run.put_text(1, nlohmann::json(motions.shortest_seconds()).dump(), recorded_duration);
  };
  return task;
}

}  // namespace mien::pipeline
