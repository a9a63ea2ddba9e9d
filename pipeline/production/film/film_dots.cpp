#include "pipeline/production/film/film_dots.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/film/film_table_forms.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

constexpr double dots_cost_seconds = 0.05;

/// One camera's part of the picture.
struct Eye {
  const char* name;
  render::Camera camera;
  int left;  ///< pixels of the picture before it
};

std::vector<Eye> eyes_at(const scenes::Shot& shot, int frame) {
  const std::vector<render::Camera> cameras = cameras_at(shot, frame);
  if (cameras.size() == 1) return {{"both", cameras[0], 0}};
  return {{"left", cameras[0], 0}, {"right", cameras[1], cameras[0].width}};
}

/// The rows of one frame of an actor's dots, counted from `first` on, as one eye sees them.
void add_rows(CsvWriter& table, const Eye& eye, const scenes::Actor& actor, int frame,
              std::size_t first) {
  const render::Camera& camera = eye.camera;
  const render::Window shown_part = window_of(camera);
  const double seconds = frame / actor.clip.frames_per_second;
  for (std::size_t d = 0; d < actor.dots.size(); ++d) {
    const scenes::Dot& dot = actor.dots[d];
    const auto shown = std::min(static_cast<std::size_t>(frame), dot.path.size() - 1);
    const motion::Vec3& at = dot.path[shown];
    auto seen = render::project(camera, at.cast<float>());
    if (seen) *seen -= Eigen::Vector2f(shown_part.x, shown_part.y);
    const bool is_visible = seen && seen->x() >= 0.0f && seen->y() >= 0.0f &&
                            seen->x() < static_cast<float>(shown_part.width) &&
                            seen->y() < static_cast<float>(shown_part.height);
    if (seen) seen->x() += static_cast<float>(eye.left);
    const auto pixels = [&](int axis) {
      return seen ? shortest(static_cast<double>((*seen)[axis])) : std::string();
    };
    table.row({std::to_string(frame), shortest(seconds), std::to_string(first + d), dot.kind,
               pixels(0), pixels(1), shortest(at.x()), shortest(at.y()), shortest(at.z()),
               is_visible ? "1" : "0", eye.name});
  }
}

}  // namespace

std::string dots_csv(const scenes::Shot& shot) {
  CsvWriter table = table_of(dots_form);
  for (int frame = 0; frame < shot.frame_count(); ++frame) {
    for (const Eye& eye : eyes_at(shot, frame)) {
      std::size_t first = 0;
      for (const scenes::Actor& actor : shot.actors) {
        add_rows(table, eye, actor, frame, first);
        first += actor.dots.size();
      }
    }
  }
  return table.text();
}

bool has_dots(const Stimulus& stimulus) {
  return std::holds_alternative<scenes::PointLightOptions>(stimulus.look.figure);
}

Task dots_task(const Stimulus& stimulus, std::uint64_t seed, const Equalize& equalize,
               const SharedDeterminants& shared, FinishedMotions& motions) {
  Task task;
  task.id = "dots:" + stimulus.id;
  task.kind = "dots";
  task.inputs = {"motion:" + stimulus.id};
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", film_code()).add("seed", static_cast<std::int64_t>(seed));
  add_film(task.determinants, stimulus, shared.files);
  task.determinants.add("duration", std::int64_t{equalize.duration});
  // What exposure changes no dot feels.
  Equalize alike = equalize;
  alike.luminance.reset();
  for (const std::string& other : equalizing_task_ids(alike)) task.inputs.push_back(other);
  task.products.push_back({"clips/" + stimulus.id + ".dots.csv", {}});
  task.cost_seconds = dots_cost_seconds;
  task.make = [&stimulus, &motions, seed, alike](TaskRun& run) {
    const Equalized found = equalized_films(alike, run.store.folder(), motions).of(stimulus.id);
    run.put_text(0, dots_csv(shot_of(stimulus, motions, seed, found.framing)), read_csv);
  };
  return task;
}

}  // namespace mien::pipeline
