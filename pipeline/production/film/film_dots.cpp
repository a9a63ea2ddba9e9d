#include "pipeline/production/film/film_dots.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/tasks/code_identity.h"
#include "scenes/point_light/marker_dots.h"

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

/// A dot of a frame as one eye sees it.
struct DotRow {
  int frame;
  double time_s;
  std::size_t number;
  const scenes::Dot& dot;
  motion::Vec3 at;
  std::optional<Eigen::Vector2f> seen;  ///< from the upper left corner of the picture
  bool is_lit;                          ///< not a marker in a gap
  bool is_visible;
  const char* eye;
  std::string_view person;  ///< empty if there is only one

  std::optional<double> pixels(int axis) const {
    return seen ? std::optional(static_cast<double>((*seen)[axis])) : std::nullopt;
  }
  std::optional<double> metres(int axis) const {
    return is_lit ? std::optional(at[axis]) : std::nullopt;
  }
};

constexpr auto dots_columns = table_of<DotRow>(
    "clips/<stimulus>.dots.csv", "frame and dot of a point-light figure or of markers",
    {{"frame", "", "frame of the film, counted from 0", [](auto& r) { return r.frame; }},
     {"time_s", "s", "time of the frame", [](auto& r) { return r.time_s; }},
     {"dot", "", "number of the dot, counted from 0; the same in all frames",
      [](auto& r) { return r.number; }},
     {"kind", "", "name of the joint or marker, limb, noise or mask",
      [](auto& r) { return r.dot.kind; }},
     {"x_px", "pixels",
      "centre of the dot from the left edge of the frame (of a stereo pair: of the whole frame "
      "with both eyes); empty if it is behind the camera or, of a marker, dark",
      [](auto& r) { return r.pixels(0); }},
     {"y_px", "pixels", "centre of the dot from the upper edge of the frame, downwards",
      [](auto& r) { return r.pixels(1); }},
     {"x_m", "m", "world position: to the figure's left; empty if dark",
      [](auto& r) { return r.metres(0); }},
     {"y_m", "m", "world position: up", [](auto& r) { return r.metres(1); }},
     {"z_m", "m", "world position: in the walking direction", [](auto& r) { return r.metres(2); }},
     {"visible", "0/1", "1: shown and inside the image (of that eye)",
      [](auto& r) { return r.is_visible; }},
     {"eye", "", "both; for a stereo pair, left or right, with one row for each",
      [](auto& r) { return r.eye; }},
     {"person", "", "name of the person whose dot it is; empty unless there are several",
      [](auto& r) { return r.person; }}});

/// The rows of one frame of an actor's dots, counted from `first` on, as one eye sees them.
void add_rows(std::vector<DotRow>& rows, const Eye& eye, const scenes::Actor& actor,
              std::string_view person, int frame, std::size_t first) {
  const render::Camera& camera = eye.camera;
  const render::Window shown_part = window_of(camera);
  for (std::size_t d = 0; d < actor.dots.size(); ++d) {
    const scenes::Dot& dot = actor.dots[d];
    const auto shown = std::min(static_cast<std::size_t>(frame), dot.path.size() - 1);
    const motion::Vec3& at = dot.path[shown];
    const bool is_lit = dot.is_shown(shown);
    auto seen = render::project(camera, at.cast<float>());
    if (!is_lit) seen.reset();
    if (seen) *seen -= Eigen::Vector2f(shown_part.x, shown_part.y);
    const bool is_visible = seen && seen->x() >= 0.0f && seen->y() >= 0.0f &&
                            seen->x() < static_cast<float>(shown_part.width) &&
                            seen->y() < static_cast<float>(shown_part.height);
    if (seen) seen->x() += static_cast<float>(eye.left);
    rows.push_back({frame, frame / actor.clip.frames_per_second, first + d, dot, at, seen, is_lit,
                    is_visible, eye.name, person});
  }
}

}  // namespace

const TableForm dots_form = dots_columns.form();

std::string dots_csv(const scenes::Shot& shot) {
  std::vector<DotRow> rows;
  const bool are_several = shot.actors.size() > 1;
  for (int frame = 0; frame < shot.frame_count(); ++frame) {
    for (const Eye& eye : eyes_at(shot, frame)) {
      std::size_t first = 0;
      for (const scenes::Actor& actor : shot.actors) {
        add_rows(rows, eye, actor, are_several ? actor.name : std::string_view(), frame, first);
        first += actor.dots.size();
      }
    }
  }
  return dots_columns.of(rows).csv;
}

bool has_dots(const Stimulus& stimulus) { return scenes::kind_of(stimulus.look.figure).has_dots; }

std::string marker_facts(const Stimulus& stimulus, FinishedMotions& motions) {
  const auto* options = std::get_if<scenes::MarkersOptions>(&stimulus.look.figure);
  if (options == nullptr || !stimulus.people.empty()) return "";
  const scenes::MarkerCounts counts =
      scenes::marker_counts(staged_clip(stimulus, motions), *options);
  const auto in_frames = [](double share) {
    return fmt::format("in {:.2g} % of their frames", 100.0 * share);
  };
  std::string facts = fmt::format("{} of {} markers", counts.shown, counts.recorded);
  if (counts.filled_share > 0.0)
    facts += ", at interpolated positions " + in_frames(counts.filled_share);
  return facts + (counts.dark_share > 0.0 ? ", dark " + in_frames(counts.dark_share)
                                          : ", dark in no frame");
}

Task dots_task(const Stimulus& stimulus, std::uint64_t seed, const Equalize& equalize,
               const SharedDeterminants& shared, FinishedMotions& motions) {
  Task task;
  task.id = "dots:" + stimulus.id;
  task.kind = "dots";
  for (const Stimulus* motion : motions_in(stimulus)) task.inputs.push_back("motion:" + motion->id);
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", film_code()).add("seed", static_cast<std::int64_t>(seed));
  add_film(task.determinants, stimulus, shared.files);
  task.determinants.add("duration", std::int64_t{equalize.duration});
  // What exposure changes no dot feels.
  Equalize applicable = equalize;
  applicable.luminance.reset();
  for (const std::string& other : equalizing_task_ids(applicable)) task.inputs.push_back(other);
  task.products.push_back({"clips/" + stimulus.id + ".dots.csv", {}});
  task.cost_seconds = dots_cost_seconds;
  task.make = [&stimulus, &motions, seed, applicable](TaskRun& run) {
    const Equalized found =
        equalized_films(applicable, run.store.folder(), motions).of(stimulus.id);
    run.put_text(0, dots_csv(shot_of(stimulus, motions, seed, found.framing)), read_csv);
  };
  return task;
}

}  // namespace mien::pipeline
