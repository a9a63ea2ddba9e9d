#include "pipeline/production/film/film_framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include <Eigen/Geometry>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"
#include "scenes/cameras/figure_place.h"

namespace mien::pipeline {

namespace {

using Eigen::Vector2d;

using SizesById = std::map<std::string, double>;

/// In steps of 1/64 pixel: no machine's arithmetic shows.
double step_below(double pixels) { return std::floor(64.0 * pixels) / 64.0; }
double nearest_step(double pixels) { return std::round(64.0 * pixels) / 64.0; }

double in_hundredths(double pixels) { return std::round(100.0 * pixels) / 100.0; }

struct EqualizedSize {
  std::string stimulus;
  double framed_px;
  double figure_px;
};

constexpr auto sizes_columns = table_of<EqualizedSize>(
    "metrics/sizes.csv", "stimulus, if size is equalized",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.stimulus; }},
     {"framed_px", "pixels", "height of the standing figure before equalizing",
      [](auto& r) { return in_hundredths(r.framed_px); }},
     {"figure_px", "pixels",
      "height in all films (in all with the same kind of figure if `equalize` has `by: figure`): "
      "the smallest of those before equalizing",
      [](auto& r) { return r.figure_px; }}});

struct EqualizedPlace {
  std::string stimulus;
  Vector2d framed;
  std::array<double, 2> common;
};

constexpr auto places_columns = table_of<EqualizedPlace>(
    "metrics/places.csv", "stimulus, if place is equalized",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.stimulus; }},
     {"framed_x_px", "pixels",
      "horizontal position before equalizing (midpoint of the path on the floor, or, for a camera "
      "that follows the figure, its own position), to the right of the image centre",
      [](auto& r) { return in_hundredths(r.framed.x()); }},
     {"framed_y_px", "pixels", "the same vertically, below the image centre",
      [](auto& r) { return in_hundredths(r.framed.y()); }},
     {"x_px", "pixels",
      "horizontal position in all films (in all with the same kind of figure if `equalize` has "
      "`by: figure`), to the right of the image centre",
      [](auto& r) { return r.common[0]; }},
     {"y_px", "pixels", "the same vertically, below the image centre",
      [](auto& r) { return r.common[1]; }}});

/// Called with the share of the stimuli that were looked at.
using Between = std::function<void(double share)>;

Between between_stimuli_of(TaskRun& run) {
  return [&run](double share) {
    if (run.stop.stop_requested()) throw Interrupted{};
    run.progress(share);
  };
}

/// What is found of each stimulus, by its id.
template <class Find>
auto found_of_all(const Manifest& manifest, const Find& find, const Between& between) {
  std::map<std::string, decltype(find(manifest.stimuli.front()))> all;
  for (const Stimulus& stimulus : manifest.stimuli) {
    all.emplace(stimulus.id, find(stimulus));
    between(static_cast<double>(all.size()) / static_cast<double>(manifest.stimuli.size()));
  }
  return all;
}

SizesById framed_sizes(const Manifest& manifest, FinishedMotions& motions, const Between& between) {
  const auto size_of = [&](const Stimulus& stimulus) {
    return scenes::figure_pixels(shot_of(stimulus, motions, manifest.seed).cameras);
  };
  return found_of_all(manifest, size_of, between);
}

SizesById common_sizes(const Manifest& manifest, const SizesById& framed) {
  SizesById common;
  for (const auto& group : equalized_groups(manifest.stimuli, *manifest.equalize.size)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Stimulus* stimulus : group) least = std::min(least, framed.at(stimulus->id));
    for (const Stimulus* stimulus : group) common[stimulus->id] = step_below(least);
  }
  return common;
}

/// Where a figure stands, and where it could without leaving its picture.
struct Standing {
  Vector2d framed;
  Eigen::AlignedBox2d possible;
};

using StandingsById = std::map<std::string, Standing>;

Standing standing_of(const scenes::Shot& shot) {
  const auto [right, below] = scenes::figure_place(shot.cameras).value();
  const Eigen::AlignedBox2d taken = scenes::action_bounds(shot.cameras, shot.action);
  const render::Camera& camera = shot.cameras.cameras.front();
  const Vector2d half = 0.5 * Vector2d(camera.width, camera.height);
  Standing standing{{right, below}, {}};
  const Vector2d least = standing.framed - half - taken.min();
  const Vector2d most = standing.framed + half - taken.max();
  const double endless = std::numeric_limits<double>::infinity();
  standing.possible = {Vector2d::Constant(-endless), Vector2d::Constant(endless)};
  for (int axis = 0; axis < 2; ++axis) {
    // What its own camera cuts may be cut elsewhere, too.
    if (standing.framed[axis] < least[axis] || standing.framed[axis] > most[axis]) continue;
    standing.possible.min()[axis] = least[axis];
    standing.possible.max()[axis] = most[axis];
  }
  return standing;
}

/// Of all stimuli; their figures are as tall as `sizes` says, or, where that is empty, as their
/// cameras do.
StandingsById standings_at(const SizesById& sizes, const Manifest& manifest,
                           FinishedMotions& motions, const Between& between) {
  const auto standing = [&](const Stimulus& stimulus) {
    Framing framing;
    if (!sizes.empty()) framing.figure_px = sizes.at(stimulus.id);
    return standing_of(shot_of(stimulus, motions, manifest.seed, framing));
  };
  return found_of_all(manifest, standing, between);
}

/// The stimulus among the group for which something is greatest.
template <class Measure>
const Stimulus& greatest(const std::vector<const Stimulus*>& group, const Measure& measure) {
  return **std::max_element(group.begin(), group.end(), [&](const auto* a, const auto* b) {
    return measure(*a) < measure(*b);
  });
}

Vector2d common_place(const std::vector<const Stimulus*>& group, const StandingsById& standings) {
  Vector2d mean = Vector2d::Zero();
  for (const Stimulus* stimulus : group) mean += standings.at(stimulus->id).framed;
  mean /= static_cast<double>(group.size());
  Vector2d place;
  for (int axis = 0; axis < 2; ++axis) {
    const auto least = [&](const Stimulus& of) { return standings.at(of.id).possible.min()[axis]; };
    const auto most = [&](const Stimulus& of) { return -standings.at(of.id).possible.max()[axis]; };
    const Stimulus& one = greatest(group, least);
    const Stimulus& other = greatest(group, most);
    if (least(one) > -most(other)) {
      throw Error("equalize: \"" + one.id + "\" and \"" + other.id +
                      "\" cannot be at the same position in the image and fully visible",
                  "equalize size as well, use place: {by: figure}, or omit place");
    }
    place[axis] = nearest_step(std::clamp(mean[axis], least(one), -most(other)));
  }
  return place;
}

/// Throws Error when there is none.
std::map<std::string, std::array<double, 2>> common_places(const Manifest& manifest,
                                                           const StandingsById& standings) {
  std::map<std::string, std::array<double, 2>> common;
  for (const auto& group : equalized_groups(manifest.stimuli, *manifest.equalize.place)) {
    const Vector2d place = common_place(group, standings);
    for (const Stimulus* stimulus : group) common[stimulus->id] = {place.x(), place.y()};
  }
  return common;
}

/// Reports errors of equalization at its place in the manifest.
template <class Find>
auto placed_in(const Manifest& manifest, const Find& find) {
  try {
    return find();
  } catch (const Error& error) {
    throw Error(place_of(manifest.places, "equalize"), error.what(), "");
  }
}

}  // namespace

const TableForm sizes_form = sizes_columns.form();
const TableForm places_form = places_columns.form();

std::string sizes_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run,
                      EqualizedFilms& films) {
  const SizesById framed = framed_sizes(manifest, motions, between_stimuli_of(run));
  films.figure_px = common_sizes(manifest, framed);
  std::vector<EqualizedSize> rows;
  for (const Stimulus& stimulus : manifest.stimuli)
    rows.push_back({stimulus.id, framed.at(stimulus.id), films.figure_px.at(stimulus.id)});
  return sizes_columns.of(rows).csv;
}

std::string places_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run,
                       EqualizedFilms& films) {
  const StandingsById standings =
      standings_at(films.figure_px, manifest, motions, between_stimuli_of(run));
  films.figure_place = placed_in(manifest, [&] { return common_places(manifest, standings); });
  std::vector<EqualizedPlace> rows;
  for (const Stimulus& stimulus : manifest.stimuli)
    rows.push_back(
        {stimulus.id, standings.at(stimulus.id).framed, films.figure_place.at(stimulus.id)});
  return places_columns.of(rows).csv;
}

void check_places(const Manifest& manifest, FinishedMotions& motions) {
  const Between quietly = [](double) {};
  SizesById sizes;
  if (manifest.equalize.size)
    sizes = common_sizes(manifest, framed_sizes(manifest, motions, quietly));
  common_places(manifest, standings_at(sizes, manifest, motions, quietly));
}

}  // namespace mien::pipeline
