#include "scenes/point_light/marker_dots.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "motion/error.h"
#include "motion/skeleton/clip_markers.h"
#include "motion/text/excerpt.h"
#include "motion/text/glob.h"
#include "motion/text/nearest_word.h"
#include "scenes/point_light/dot_display.h"

namespace mien::scenes {

namespace {

using motion::Markers;
using motion::Vec3;

constexpr float stick_share = 0.3f;  // of the dots' diameter

const Markers& require_markers(const motion::Clip& clip) {
  if (const Markers* markers = motion::markers_of(clip)) return *markers;
  throw Error({clip.name}, "this motion has no markers to show",
              "show an unmodified recording of markers (in an AMASS file the take markers: "
              "FILE.npz#markers), or choose another figure, such as point-light");
}

bool is_lit(const Markers& markers, const MarkersOptions& options, int frame, int point) {
  const std::size_t at = markers.at(frame, point);
  return markers.seen[at] || (options.fills_gaps && markers.filled[at]);
}

bool is_ever_lit(const Markers& markers, const MarkersOptions& options, int point) {
  for (int frame = 0; frame < markers.frame_count(); ++frame) {
    if (is_lit(markers, options, frame, point)) return true;
  }
  return false;
}

/// "markers.pairs[2]"
std::string option_at(const char* option, std::size_t index) {
  return "markers." + std::string(option) + "[" + std::to_string(index) + "]";
}

/// For each marker, whether a pattern names it.
std::vector<bool> chosen_points(const motion::Clip& clip, const Markers& markers,
                                const std::vector<std::string>& patterns) {
  std::vector<bool> chosen(markers.points.size(), patterns.empty());
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    bool fits = false;
    for (std::size_t p = 0; p < markers.points.size(); ++p) {
      if (!motion::matches_glob(patterns[i], markers.points[p])) continue;
      fits = chosen[p] = true;
    }
    if (fits) continue;
    throw Error({clip.name},
                option_at("show", i) + ": no marker fits " + motion::in_quotes(patterns[i]),
                motion::did_you_mean(patterns[i], markers.points));
  }
  return chosen;
}

/// The dot of a marker that a pair names; nothing if it is dark in all frames.
std::optional<std::size_t> dot_of(const std::string& name, const motion::Clip& clip,
                                  const Markers& markers, const std::vector<bool>& chosen,
                                  const std::vector<int>& dots, std::size_t pair) {
  const auto found = std::ranges::find(markers.points, name);
  if (found == markers.points.end()) {
    throw Error({clip.name},
                option_at("pairs", pair) + ": there is no marker " + motion::in_quotes(name),
                motion::did_you_mean(name, markers.points));
  }
  const auto point = static_cast<std::size_t>(found - markers.points.begin());
  if (!chosen[point]) {
    throw Error({clip.name},
                option_at("pairs", pair) + ": marker " + motion::in_quotes(name) + " is not shown",
                "add it to show, or omit the pair");
  }
  const auto dot = std::ranges::find(dots, static_cast<int>(point));
  if (dot == dots.end()) return std::nullopt;
  return static_cast<std::size_t>(dot - dots.begin());
}

Dot dot_of(const Markers& markers, const MarkersOptions& options, int point, const Vec3& step) {
  Dot dot{markers.points[static_cast<std::size_t>(point)], {}};
  for (int frame = 0; frame < markers.frame_count(); ++frame) {
    dot.path.push_back(markers.positions[markers.at(frame, point)]);
    dot.shown.push_back(is_lit(markers, options, frame, point));
  }
  if (std::ranges::all_of(dot.shown, [](bool shown) { return shown; })) {
    dot.shown.clear();
  } else {
    dot.path = with_travel(motion::bridged(without_travel(dot.path, step), dot.shown), step);
  }
  return dot;
}

/// The radius in space of what has this diameter in the picture; 0 behind the camera.
float radius_at(const render::Vec3& place, const PointLightOptions& options,
                const render::CameraFrame& camera) {
  if (options.size_m) return static_cast<float>(0.5 * *options.size_m);
  const float depth = (place - camera.position).dot(camera.forward);
  if (!camera.parallel && depth <= 0.0f) return 0.0f;
  const float pixel = camera.step_right.norm();
  return static_cast<float>(0.5 * options.size_px) * (camera.parallel ? pixel : pixel * depth);
}

}  // namespace

ShownMarkers shown_markers(const motion::Clip& clip, const MarkersOptions& options) {
  const Markers& markers = require_markers(clip);
  const std::vector<bool> chosen = chosen_points(clip, markers, options.show);
  ShownMarkers shown;
  for (int point = 0; point < markers.point_count(); ++point) {
    if (chosen[static_cast<std::size_t>(point)] && is_ever_lit(markers, options, point))
      shown.points.push_back(point);
  }
  if (shown.points.empty()) {
    throw Error({clip.name}, "its markers are missing in all frames",
                options.fills_gaps ? "show others, or another figure"
                                   : "show others, or those filled in (gaps: fill)");
  }
  for (std::size_t i = 0; i < options.pairs.size(); ++i) {
    const auto& [from, to] = options.pairs[i];
    const auto near = dot_of(from, clip, markers, chosen, shown.points, i);
    const auto far = dot_of(to, clip, markers, chosen, shown.points, i);
    if (near && far) shown.pairs.push_back({*near, *far});
  }
  return shown;
}

std::vector<Dot> marker_dots(const motion::Clip& clip, const MarkersOptions& options,
                             const DotStage& stage) {
  const ShownMarkers shown = shown_markers(clip, options);
  const PointLightOptions& dots = options.dots;
  if (!options.pairs.empty() && (dots.scrambled || dots.phase_scrambled)) {
    throw Error("scrambled markers are not on a body, as pairs require", "omit scrambled or pairs");
  }
  if (dots.lifetime > 0 && !dots.scrambled && shown.pairs.empty()) {
    throw Error({clip.name}, "these markers are not on limbs, as a limited lifetime requires",
                "name the two markers of each limb in pairs, or omit lifetime");
  }
  const Markers& markers = require_markers(clip);
  std::vector<Dot> figure;
  for (const int point : shown.points) {
    figure.push_back(dot_of(markers, options, point, stage.step));
  }
  return displayed_dots(std::move(figure), shown.pairs, dots, stage);
}

std::vector<std::vector<Vec3>> marker_places(const motion::Clip& clip,
                                             const MarkersOptions& options) {
  const Markers& markers = require_markers(clip);
  const std::vector<int> points = shown_markers(clip, options).points;
  std::vector<std::vector<Vec3>> places(clip.poses.size());
  for (int frame = 0; frame < markers.frame_count(); ++frame) {
    for (const int point : points) {
      if (is_lit(markers, options, frame, point))
        places[static_cast<std::size_t>(frame)].push_back(
            markers.positions[markers.at(frame, point)]);
    }
  }
  return places;
}

void add_sticks(render::Scene& scene, const std::vector<Dot>& dots, const std::vector<Limb>& pairs,
                int frame, const PointLightOptions& options, const render::Camera& camera) {
  const auto material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(
      {.albedo = render::Color::Zero(), .emission = dot_colours(options).dots});
  const render::CameraFrame camera_frame = render::frame_of(camera);
  const auto f = static_cast<std::size_t>(frame);
  for (const auto& [near, far] : pairs) {
    if (!dots[near].is_shown(f) || !dots[far].is_shown(f)) continue;
    const render::Vec3 start = dots[near].path[f].cast<float>();
    const render::Vec3 end = dots[far].path[f].cast<float>();
    const float start_radius = stick_share * radius_at(start, options, camera_frame);
    const float end_radius = stick_share * radius_at(end, options, camera_frame);
    if (start_radius <= 0.0f || end_radius <= 0.0f) continue;
    scene.solids.round_cones.push_back({start, end, start_radius, end_radius, material});
  }
}

MarkerCounts marker_counts(const motion::Clip& clip, const MarkersOptions& options) {
  const Markers& markers = require_markers(clip);
  const std::vector<int> points = shown_markers(clip, options).points;
  std::size_t dark = 0, filled = 0;
  for (int frame = 0; frame < markers.frame_count(); ++frame) {
    for (const int point : points) {
      if (!is_lit(markers, options, frame, point)) ++dark;
      if (options.fills_gaps && markers.filled[markers.at(frame, point)]) ++filled;
    }
  }
  const auto all = static_cast<double>(points.size()) * static_cast<double>(markers.frame_count());
  return {markers.points.size(), points.size(), static_cast<double>(dark) / all,
          static_cast<double>(filled) / all};
}

}  // namespace mien::scenes
