#include "scenes/stage/shot.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/clip_markers.h"
#include "motion/text/excerpt.h"
#include "scenes/cameras/camera_path.h"
#include "scenes/cameras/figure_place.h"
#include "scenes/point_light/dot_joints.h"
#include "scenes/point_light/marker_dots.h"
#include "scenes/stage/trail_figure.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr double least_speed = 0.05;  // m/s

constexpr double lane_m = 1.1;

/// The clip turned about the vertical through `from` and put down at `to`.
motion::Clip moved(motion::Clip clip, const motion::Quat& turn, const Vec3& from, const Vec3& to) {
  for (motion::Pose& pose : clip.poses) {
    const double height = pose.root_position.y();
    pose.root_position = to + turn * (pose.root_position - from);
    pose.root_position.y() = height;
    pose.rotations.front() = turn * pose.rotations.front();
  }
  return clip;
}

Vec3 on_floor(const Vec3& point) { return {point.x(), 0.0, point.z()}; }

/// The clips where the layout wants them: unless they stay as recorded, all begin where the first
/// one does.
std::vector<Performance> laid_out(std::vector<Performance> performances, Layout layout) {
  if (layout == Layout::as_recorded) return performances;
  const Vec3 forward = action_of(performances.front().clip).forward;
  const Vec3 start = on_floor(performances.front().clip.poses.front().root_position);
  const Vec3 right = forward.cross(Vec3::UnitY());
  const auto count = static_cast<double>(performances.size());
  for (std::size_t i = 1; i < performances.size(); ++i) {
    motion::Clip& clip = performances[i].clip;
    const motion::Quat turn =
        motion::heading(forward) * motion::heading(action_of(clip).forward).conjugate();
    clip = moved(clip, turn, on_floor(clip.poses.front().root_position), start);
  }
  if (layout == Layout::superimposed) return performances;
  for (std::size_t i = 0; i < performances.size(); ++i) {
    // The figures face the camera: what is at their right is at the left of the picture.
    const double lane = 0.5 * (count - 1.0) - static_cast<double>(i);
    for (motion::Pose& pose : performances[i].clip.poses) {
      pose.root_position += lane * lane_m * right;
    }
  }
  return performances;
}

/// The performances where single precision is fine enough: a thousand metres from the origin a foot
/// would tremble. What begins nearby stays where it is.
std::vector<Performance> near_origin(std::vector<Performance> performances) {
  constexpr double far_m = 100.0;
  const Vec3 start = on_floor(performances.front().clip.poses.front().root_position);
  if (start.norm() < far_m) return performances;
  for (Performance& one : performances) {
    motion::Clip near = one.clip;
    for (motion::Pose& pose : near.poses) pose.root_position -= start;
    carry_markers(one.clip, near, [&](int, const Vec3& place) -> Vec3 { return place - start; });
    one.clip = std::move(near);
  }
  return performances;
}

/// On the floor, of the box around all points.
Vec3 centre_of(const std::vector<std::vector<Vec3>>& points) {
  Vec3 least = points.front().front();
  Vec3 most = least;
  for (const auto& frame : points) {
    for (const Vec3& point : frame) {
      least = least.cwiseMin(point);
      most = most.cwiseMax(point);
    }
  }
  return on_floor(0.5 * (least + most));
}

/// The action of an actor: of its body, and of the markers that are shown, which may be elsewhere.
Action shown_action(const Actor& actor, const Figure& figure) {
  Action action = action_of(actor.clip);
  const auto* markers = std::get_if<MarkersOptions>(&figure);
  if (markers == nullptr) return action;
  const auto places = marker_places(actor.clip, *markers);
  for (std::size_t f = 0; f < places.size(); ++f) {
    action.points[f].insert(action.points[f].end(), places[f].begin(), places[f].end());
  }
  return action;
}

/// The common action of all actors.
Action shared_action(const std::vector<Actor>& actors, const Figure& figure) {
  Action action = shown_action(actors.front(), figure);
  for (std::size_t i = 1; i < actors.size(); ++i) {
    const Action more = shown_action(actors[i], figure);
    const std::size_t count = std::max(action.points.size(), more.points.size());
    for (std::size_t f = 0; f < count; ++f) {
      const auto& points = more.points[std::min(f, more.points.size() - 1)];
      if (f >= action.points.size()) action.points.push_back(action.points.back());
      action.points[f].insert(action.points[f].end(), points.begin(), points.end());
    }
    action.height_m = std::max(action.height_m, more.height_m);
  }
  action.centre = centre_of(action.points);
  return action;
}

/// What the camera is to frame of all actors; empty: everything.
std::vector<std::vector<Vec3>> framed_points(const std::vector<Actor>& actors,
                                             CameraSubject subject) {
  std::vector<std::vector<Vec3>> framed;
  for (const Actor& actor : actors) {
    std::vector<std::vector<Vec3>> points = subject_points(actor.clip, subject);
    if (points.size() > framed.size()) framed.resize(points.size());
    for (std::size_t f = 0; f < points.size(); ++f)
      framed[f].insert(framed[f].end(), points[f].begin(), points[f].end());
  }
  return framed;
}

/// The belt has to be in the picture too.
void include(const Belt& belt, const Place& place, Action& action) {
  constexpr double frame_m = 0.12;  // round the belt
  const Vec3 corner(0.5 * belt.width_m + frame_m, 0.0, 0.5 * belt.length_m + frame_m);
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      action.points.front().push_back(place.at({x * corner.x(), 0.0, z * corner.z()}));
    }
  }
}

/// The seed of an actor's dots, so that those of several actors are independent of each other.
std::uint64_t seed_of(std::size_t actor, std::uint64_t seed) {
  constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15ULL;  // Steele, Lea and Flood 2014
  return seed + actor * golden_ratio;
}

DotStage dot_stage(const Shot& shot, const motion::Clip& clip, std::uint64_t seed) {
  const render::CameraFrame frame = render::frame_of(shot.cameras.at(0));
  DotStage stage;
  stage.centre = shot.place.centre;
  stage.across = on_floor(frame.step_right.cast<double>()).normalized();
  stage.step = mean_step(clip);
  stage.seed = seed;
  return stage;
}

std::vector<Dot> dots_of(const Actor& actor, const Figure& figure, const DotStage& stage) {
  if (const auto* markers = std::get_if<MarkersOptions>(&figure))
    return marker_dots(actor.clip, *markers, stage);
  return point_light(actor.clip, std::get<PointLightOptions>(figure), stage);
}

/// `options` are those of the figure's dots.
void place_dots(Shot& shot, const Figure& figure, const PointLightOptions& options,
                std::uint64_t seed) {
  shot.tone.shoulder = 1.0f;
  const DotStage stage = dot_stage(shot, shot.actors.front().clip, seed);
  if (shot.set.in_place) {
    DotStage going = stage;
    going.step = shot.step;
    shot.step = changed_step(options, going);
  }
  for (std::size_t i = 0; i < shot.actors.size(); ++i) {
    Actor& actor = shot.actors[i];
    actor.dots = dots_of(actor, figure, dot_stage(shot, actor.clip, seed_of(i, seed)));
  }
}

/// The action when the figures' dots are where their options put them. Of dots
/// that keep their places it is the given action.
Action dotted_action(const Shot& shot, const PointLightOptions& options, Action action,
                     std::uint64_t seed) {
  if (!options.reversed && !options.mirrored && options.rotated_degrees == 0.0) return action;
  for (auto& points : action.points) points.clear();
  for (const Actor& actor : shot.actors) {
    DotPath way;
    for (const motion::Pose& pose : actor.clip.poses) way.push_back(pose.root_position);
    way = changed_path(way, options, dot_stage(shot, actor.clip, seed));
    for (std::size_t f = 0; f < action.points.size(); ++f) {
      const std::size_t shown = std::min(f, way.size() - 1);
      action.points[f].push_back(way[shown]);
      for (const Dot& dot : actor.dots) {
        if (dot.is_shown(shown)) action.points[f].push_back(dot.path[shown]);
      }
    }
  }
  action.centre = centre_of(action.points);
  if (shot.set.belt) include(*shot.set.belt, shot.place, action);
  return action;
}

/// The figure that can be drawn of the motions. Points to which no body could be fitted have a
/// single joint: instead of a stick figure of it, they are shown as balls.
Figure drawable(const Figure& figure, const std::vector<Performance>& performances) {
  const motion::Clip& clip = performances.front().clip;
  const bool are_points_alone = performances.size() == 1 && clip.body.joints.size() == 1 &&
                                motion::markers_of(clip) != nullptr;
  if (!std::holds_alternative<StickOptions>(figure) || !are_points_alone) return figure;
  MarkersOptions balls;
  balls.dots.size_m = 0.03;
  balls.dots.colour = "#404850";
  return balls;
}

/// An actor in the look's figure and its role's colours, unless the performance has its own.
Actor actor_of(const Performance& one, const Look& look) {
  const Figure& figure = one.figure ? *one.figure : look.figure;
  const FigureColours colours = one.colours ? *one.colours : colours_of(one.role);
  const Hands hands = one.hands.value_or(look.hands);
  Actor actor = make_actor(with_shown_hands(one.clip, hands), figure, colours, look.detail);
  actor.name = one.name;
  actor.opacity = one.opacity;
  const PointLightOptions* dots = dots_in(figure);
  const bool shows_hands = dots == nullptr || has_dots_on_fingers(*dots);
  if (shows_hands && gets_relaxed_hands(one.clip, hands))
    actor.warnings.emplace_back(
        actor.has_hands
            ? "The motion has no fingers; relaxed hands are drawn."
            : "The character's rig has no fingers; its hands stay as they are modelled.");
  return actor;
}

/// Warnings about one of several motions say whose it is.
void name_in_warnings(std::vector<Actor>& actors) {
  if (actors.size() < 2) return;
  for (Actor& actor : actors)
    for (std::string& warning : actor.warnings)
      if (!actor.name.empty()) warning = motion::in_quotes(actor.name) + ": " + warning;
}

/// Throws Error for figures that cannot be shown together in this way.
void refuse_together(const Look& look) {
  const FigureKind& kind = kind_of(look.figure);
  const std::string not_together = kind.not_in_overlays;
  // Where everybody has a place of their own, dots can be told apart.
  const bool are_apart = look.layout == Layout::as_recorded && kind.has_dots;
  if (!not_together.empty() && !are_apart)
    throw Error(not_together, "give them another figure, or render them separately");
  if (look.layout == Layout::side_by_side && looks_across_lanes(look.camera)) {
    throw Error("figures side by side hide each other in a side view",
                "choose front, three-quarter or follow, or layout: superimposed");
  }
}

}  // namespace

motion::Clip placed(const motion::Clip& clip, const Vec3& place, double turn_radians) {
  const Vec3 forward(std::sin(turn_radians), 0.0, std::cos(turn_radians));
  const motion::Quat turn =
      motion::heading(forward) * motion::heading(action_of(clip).forward).conjugate();
  const Vec3 from = on_floor(clip.poses.front().root_position);
  motion::Clip there = moved(clip, turn, from, on_floor(place));
  carry_markers(clip, there,
                [&](int, const Vec3& at) -> Vec3 { return on_floor(place) + turn * (at - from); });
  return there;
}

motion::Clip shifted(const motion::Clip& clip, const Vec3& shift) {
  motion::Clip there = clip;
  for (motion::Pose& pose : there.poses) pose.root_position += shift;
  carry_markers(clip, there, [&](int, const Vec3& at) -> Vec3 { return at + shift; });
  return there;
}

motion::Vec3 mean_step(const motion::Clip& clip) {
  if (clip.frame_count() < 2) return motion::Vec3::Zero();
  motion::Vec3 way = clip.poses.back().root_position - clip.poses.front().root_position;
  way.y() = 0.0;
  const motion::Vec3 step = way / (clip.frame_count() - 1);
  const bool goes = step.norm() * clip.frames_per_second >= least_speed;
  return goes ? step : motion::Vec3::Zero();
}

motion::Clip on_the_spot(const motion::Clip& clip, const motion::Vec3& step) {
  motion::Clip still = clip;
  double frame = 0.0;
  for (motion::Pose& pose : still.poses) pose.root_position -= frame++ * step;
  carry_markers(clip, still, [&](int f, const Vec3& place) -> Vec3 { return place - f * step; });
  return still;
}

bool looks_across_lanes(const CameraSettings& camera) {
  return camera.view == "side" && camera.path.empty() && !camera.position;
}

int Shot::frame_count() const {
  int most = 0;
  for (const Actor& actor : actors) most = std::max(most, actor.clip.frame_count());
  return most;
}

Shot stage(const motion::Clip& clip, const Look& look) {
  return stage(std::vector<Performance>{{.clip = clip, .role = look.role}}, look);
}

Shot stage(const std::vector<Performance>& performances, const Look& given) {
  Look look = given;
  look.figure = drawable(given.figure, performances);
  if (performances.size() > 1) refuse_together(look);
  if (auto* dots = dots_in(look.figure)) dots->size_px *= look.pixel_scale;
  if (look.camera.figure_px) *look.camera.figure_px *= look.pixel_scale;
  Shot shot;
  shot.set = look.set;
  shot.size = look.size;
  for (const Performance& one : near_origin(laid_out(performances, look.layout)))
    shot.actors.push_back(actor_of(one, look));
  name_in_warnings(shot.actors);
  shot.place.forward = look.forward ? *look.forward : action_of(shot.actors.front().clip).forward;
  if (look.in_place || look.set.in_place) {
    shot.step = mean_step(shot.actors.front().clip);
    for (Actor& actor : shot.actors) {
      const Vec3 step = mean_step(actor.clip);
      actor.clip = on_the_spot(actor.clip, step);
    }
  }
  shot.action = shared_action(shot.actors, look.figure);
  shot.action.forward = shot.place.forward;
  shot.action.framed = framed_points(shot.actors, look.camera.subject);
  shot.place.centre = shot.action.centre;
  if (shot.set.belt) include(*shot.set.belt, shot.place, shot.action);
  if (shot.set.stool)
    for (const Actor& actor : shot.actors)
      shot.set.boxes.push_back(stool_under(*shot.set.stool, actor.clip, shot.place));
  shot.static_scene = static_scene(shot.set, shot.place);
  shot.cameras = make_camera_rig(look.camera, shot.action, look.size);
  for (Actor& actor : shot.actors) {
    if (actor.trail) actor.traces = traces_of(actor.clip, *actor.trail);
  }
  if (const PointLightOptions* dots = dots_in(look.figure)) {
    place_dots(shot, look.figure, *dots, look.seed);
    // The cameras see the dots, which may go elsewhere than the figure would.
    shot.action = dotted_action(shot, *dots, std::move(shot.action), look.seed);
    shot.cameras = make_camera_rig(look.camera, shot.action, look.size);
  }
  if (look.figure_place) place_figure_at(shot.cameras, *look.figure_place);
  for (render::Camera& camera : shot.cameras.cameras) camera.window = look.window;
  return shot;
}

render::Scene scene_at(const Shot& shot, int frame) { return scene_at(shot, frame, frame); }

render::Scene scene_at(const Shot& shot, int frame, int made_at) {
  render::Scene scene = shot.static_scene;
  const render::Camera& camera = shot.cameras.at(frame);
  add_walls(scene, shot.set, shot.place, camera.position.cast<double>());
  if (shot.set.in_place) {
    add_moving_ground(scene, shot.set, shot.place, -frame * shot.step, -made_at * shot.step);
  }
  for (const Actor& actor : shot.actors) add_actor(scene, actor, frame, made_at, camera);
  return scene;
}

std::vector<render::Camera> cameras_at(const Shot& shot, int frame) {
  const CameraRig& rig = shot.cameras;
  if (rig.stereo_separation_m <= 0.0) return {rig.at(frame)};
  const auto [left, right] = stereo_pair(rig.at(frame), rig.stereo_separation_m, rig.convergence_m);
  return {left, right};
}

const render::Camera& camera_at(const Shot& shot, int frame) { return shot.cameras.at(frame); }

}  // namespace mien::scenes
