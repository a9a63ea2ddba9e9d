#include "pipeline/film_dots.h"

#include <algorithm>
#include <filesystem>
#include <variant>
#include <vector>

#include "pipeline/code_identity.h"
#include "pipeline/csv.h"
#include "pipeline/files.h"
#include "pipeline/film_shot.h"

namespace mien::pipeline {

namespace {

constexpr double dots_cost_seconds = 0.05;

/// The rows of one frame of an actor's dots, counted from `first` on.
void add_rows(CsvWriter& table, const scenes::Shot& shot, const scenes::Actor& actor, int frame,
              std::size_t first) {
  const render::Camera& camera = camera_at(shot, frame);
  const double seconds = frame / actor.clip.frames_per_second;
  for (std::size_t d = 0; d < actor.dots.size(); ++d) {
    const scenes::Dot& dot = actor.dots[d];
    const auto shown = std::min(static_cast<std::size_t>(frame), dot.path.size() - 1);
    const motion::Vec3& at = dot.path[shown];
    const auto seen = render::project(camera, at.cast<float>());
    const bool is_visible = seen && seen->x() >= 0.0f && seen->y() >= 0.0f &&
                            seen->x() < static_cast<float>(camera.width) &&
                            seen->y() < static_cast<float>(camera.height);
    const auto pixels = [&](int axis) {
      return seen ? shortest(static_cast<double>((*seen)[axis])) : std::string();
    };
    table.row({std::to_string(frame), shortest(seconds), std::to_string(first + d), dot.kind,
               pixels(0), pixels(1), shortest(at.x()), shortest(at.y()), shortest(at.z()),
               is_visible ? "1" : "0"});
  }
}

}  // namespace

std::string dots_csv(const scenes::Shot& shot) {
  CsvWriter table(
      {"frame", "time_s", "dot", "kind", "x_px", "y_px", "x_m", "y_m", "z_m", "visible"});
  for (int frame = 0; frame < shot.frame_count(); ++frame) {
    std::size_t first = 0;
    for (const scenes::Actor& actor : shot.actors) {
      add_rows(table, shot, actor, frame, first);
      first += actor.dots.size();
    }
  }
  return table.text();
}

bool has_dots(const Stimulus& stimulus) {
  return std::holds_alternative<scenes::PointLightOptions>(stimulus.look.figure);
}

Task dots_task(const Stimulus& stimulus, std::uint64_t seed, const SharedDeterminants& shared,
               Motions& motions) {
  Task task;
  task.id = "dots:" + stimulus.id;
  task.kind = "dots";
  task.inputs = {"motion:" + stimulus.id};
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", film_code()).add("seed", static_cast<std::int64_t>(seed));
  add_film(task.determinants, stimulus);
  task.products.push_back({"clips/" + stimulus.id + ".dots.csv", {}});
  task.cost_seconds = dots_cost_seconds;
  task.make = [&stimulus, &motions, seed](TaskRun& run) {
    const std::string text = dots_csv(shot_of(stimulus, motions, seed));
    run.store.put(
        run.task.products[0].path, run.keys[0],
        [&](const std::filesystem::path& file) { write_file(file, text); },
        [](const std::filesystem::path& file) { read_csv(file); });
  };
  return task;
}

}  // namespace mien::pipeline
