#include "scenes/cameras/camera_rig.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "scenes/cameras/camera_path.h"
#include "scenes/cameras/framing.h"
#include "scenes/figures/figure.h"
#include "scenes/sets/set_plan.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr double travels_m = 0.5;
constexpr int smoothing = 15;  // frames on either side

/// Where a camera stands as seen from the action: azimuth from the figure's front towards its
/// right, and elevation; radians.
struct Viewpoint {
  double azimuth;
  double elevation;
};

Viewpoint viewpoint_of(std::string_view name) {
  const double degree = motion::radians_per_degree;
  if (name == "front") return {0.0, 6.0 * degree};
  if (name == "side") return {90.0 * degree, 6.0 * degree};
  return {42.0 * degree, 10.0 * degree};
}

/// Unit vector from the action towards the camera.
Vec3 towards_camera(const Viewpoint& view, const Vec3& forward) {
  const Vec3 right = forward.cross(Vec3::UnitY());
  const Vec3 level = std::cos(view.azimuth) * forward + std::sin(view.azimuth) * right;
  return std::cos(view.elevation) * level + std::sin(view.elevation) * Vec3::UnitY();
}

std::vector<Vec3> all_points(const Action& action) {
  std::vector<Vec3> all;
  for (const auto& frame : action.framed) all.insert(all.end(), frame.begin(), frame.end());
  if (!action.framed.empty()) return all;
  for (const auto& frame : action.points) {
    for (const Vec3& point : frame) {
      all.push_back(point);
      // The floor under the figure, so that feet and shadow have something to stand on.
      all.emplace_back(point.x(), 0.0, point.z());
    }
  }
  return all;
}

/// The root's path over the floor, smoothed so that the camera does not bob with the steps.
std::vector<Vec3> smooth_path(const Action& action, int half_width) {
  const int count = static_cast<int>(action.points.size());
  std::vector<Vec3> path;
  for (int f = 0; f < count; ++f) {
    // The window shrinks towards the ends, symmetrically: a straight walk keeps its speed.
    const int reach = std::min({half_width, f, count - 1 - f});
    Vec3 sum = Vec3::Zero();
    for (int k = -reach; k <= reach; ++k) sum += action.points[static_cast<size_t>(f + k)][0];
    Vec3 mean = sum / (2 * reach + 1);
    mean.y() = 0.0;
    path.push_back(mean);
  }
  return path;
}

CameraRig follow(const Action& action, const Vec3& towards, const Lens& lens) {
  const std::vector<Vec3> path = smooth_path(action, smoothing);
  std::vector<Vec3> beside;
  for (size_t f = 0; f < action.framed.size(); ++f)
    for (const Vec3& point : action.framed[f]) beside.push_back(point - path[f]);
  for (size_t f = 0; action.framed.empty() && f < action.points.size(); ++f) {
    for (const Vec3& point : action.points[f]) {
      beside.push_back(point - path[f]);
      beside.emplace_back(point.x() - path[f].x(), 0.0, point.z() - path[f].z());
    }
  }
  const render::Camera still = framing(beside, action.margin_m, towards, lens);
  CameraRig rig;
  for (const Vec3& shift : path) {
    rig.cameras.push_back(still);
    rig.cameras.back().position += shift.cast<float>();
    rig.cameras.back().target += shift.cast<float>();
  }
  return rig;
}

CameraRig orbit(const Action& action, const Lens& lens) {
  // The action as a cylinder: its framing is the same from all sides, so the figure keeps its size.
  double radius = 0.0;
  double height = 0.0;
  double low = action.framed.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (const auto& frame : action.framed.empty() ? action.points : action.framed) {
    for (const Vec3& point : frame) {
      radius = std::max(radius,
                        std::hypot(point.x() - action.centre.x(), point.z() - action.centre.z()));
      height = std::max(height, point.y());
      low = std::min(low, action.framed.empty() ? low : point.y());
    }
  }
  std::vector<Vec3> rim;
  for (int k = 0; k < 32; ++k) {
    const double turn = 2.0 * motion::pi * k / 32;
    const Vec3 out(radius * std::sin(turn), low, radius * std::cos(turn));
    rim.push_back(out);
    rim.emplace_back(out.x(), height, out.z());
  }
  const Viewpoint start = viewpoint_of("three-quarter");
  const render::Camera still =
      framing(rim, action.margin_m, towards_camera({0.0, start.elevation}, Vec3::UnitZ()), lens);
  CameraRig rig;
  const int count = static_cast<int>(action.points.size());
  for (int f = 0; f < count; ++f) {
    const double azimuth = start.azimuth + 2.0 * motion::pi * f / count;
    // `still` looks at the action from +Z; turn it to where the azimuth says.
    const motion::Quat turn = motion::heading(towards_camera({azimuth, 0.0}, action.forward));
    const auto placed = [&](const render::Vec3& point) -> render::Vec3 {
      return (action.centre + turn * point.cast<double>()).cast<float>();
    };
    rig.cameras.push_back(still);
    rig.cameras.back().position = placed(still.position);
    rig.cameras.back().target = placed(still.target);
  }
  return rig;
}

Lens lens_of(const CameraSettings& settings, std::array<int, 2> size) {
  Lens lens;
  lens.size = size;
  lens.orthographic = settings.orthographic;
  if (settings.fov_degrees) lens.fov_radians = *settings.fov_degrees * motion::radians_per_degree;
  if (settings.screen) {
    const double height_cm = settings.screen->width_cm * size[1] / size[0];
    lens.fov_radians = 2.0 * std::atan(0.5 * height_cm / settings.screen->distance_cm);
  }
  return lens;
}

/// A point of CameraSettings in world space.
Vec3 at(const Action& action, const Vec3& point) {
  return Place{action.centre, action.forward}.at(point);
}

CameraRig standing(const Vec3& position, const Vec3& target, const Lens& lens) {
  return {{look_at_camera(position, target, lens)}};
}

CameraRig on_path(const CameraSettings& settings, const Action& action, const Lens& lens) {
  CameraRig rig;
  for (std::size_t f = 0; f < action.points.size(); ++f) {
    const double seconds = static_cast<double>(f) / action.frames_per_second;
    const CameraKey key = camera_on_path(settings.path, seconds);
    rig.cameras.push_back(look_at_camera(at(action, key.position), at(action, key.target), lens));
  }
  return rig;
}

CameraRig viewed(const std::string& view, const Action& action, const Lens& lens) {
  const std::vector<std::string> names = camera_names();
  if (std::find(names.begin(), names.end(), view) == names.end()) {
    throw Error("there is no camera \"" + view + "\"",
                "choose front, side, three-quarter, follow or orbit");
  }
  if (view == "orbit") return orbit(action, lens);
  const Vec3 towards = towards_camera(viewpoint_of(view), action.forward);
  if (view == "follow") return follow(action, towards, lens);
  return {{framing(all_points(action), action.margin_m, towards, lens)}};
}

/// Moves cameras along their axes so that each is `distance` metres from the middle of the figure:
/// where it is at the moment when they follow it, and else where it is on the whole.
void step_to(CameraRig& rig, const std::string& view, const Action& action, double distance) {
  const Vec3 middle = 0.5 * action.height_m * Vec3::UnitY();
  const std::vector<Vec3> path =
      view == "follow" ? smooth_path(action, smoothing) : std::vector<Vec3>{action.centre};
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    render::Camera& camera = rig.cameras[i];
    const Vec3 focus = middle + path[std::min(i, path.size() - 1)];
    const Vec3 ahead = (camera.target - camera.position).cast<double>().normalized();
    camera.position = (focus - distance * ahead).cast<float>();
    camera.target = focus.cast<float>();
  }
}

/// How far before the camera the middle of a figure is.
double depth_of(const render::Camera& camera, const Vec3& centre, double height_m) {
  const Vec3 eye = camera.position.cast<double>();
  const Vec3 ahead = (camera.target.cast<double>() - eye).normalized();
  return (centre + 0.5 * height_m * Vec3::UnitY() - eye).dot(ahead);
}

/// Shows the figure so many times as large: the cameras go nearer along their axes.
void magnify(CameraRig& rig, double times) {
  const double nearer = rig.figure_distance_m * (1.0 - 1.0 / times);
  for (render::Camera& camera : rig.cameras) {
    if (camera.parallel_height > 0.0f) {
      camera.parallel_height /= static_cast<float>(times);
      continue;
    }
    const Vec3 ahead = (camera.target - camera.position).cast<double>().normalized();
    camera.position += (nearer * ahead).cast<float>();
    camera.target += (nearer * ahead).cast<float>();
  }
  if (rig.cameras.front().parallel_height == 0.0f) rig.figure_distance_m -= nearer;
}

/// Without a distance the focus goes with the figure, so there is a camera for each moment.
void open_aperture(CameraRig& rig, const DepthOfField& lens, const Action& action) {
  constexpr double nearest = 0.1;  // metres
  const std::vector<Vec3> path = smooth_path(action, smoothing);
  if (!lens.focus_m) rig.cameras.resize(std::max(rig.cameras.size(), path.size()), rig.cameras[0]);
  for (std::size_t f = 0; f < rig.cameras.size(); ++f) {
    render::Camera& camera = rig.cameras[f];
    const double focus =
        lens.focus_m ? *lens.focus_m
                     : depth_of(camera, path[std::min(f, path.size() - 1)], action.height_m);
    camera.aperture_radius = static_cast<float>(0.5 * lens.aperture_m);
    camera.focus_distance = static_cast<float>(std::max(focus, nearest));
  }
}

}  // namespace

std::vector<std::string> camera_names() {
  return {"front", "side", "three-quarter", "follow", "orbit"};
}

Action action_of(const motion::Clip& clip) {
  Action action;
  action.frames_per_second = clip.frames_per_second;
  action.height_m = figure_height(clip);
  Vec3 facing = Vec3::Zero();
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 most = -least;
  for (const motion::Pose& pose : clip.poses) {
    const motion::JointTransforms world = motion::world_transforms(clip.body, pose);
    std::vector<Vec3> points = world.positions;
    for (size_t j = 0; j < clip.body.joints.size(); ++j) {
      const auto& tip = clip.body.joints[j].tip;
      if (tip) points.push_back(world.positions[j] + world.rotations[j] * *tip);
    }
    for (const Vec3& point : points) {
      least = least.cwiseMin(point);
      most = most.cwiseMax(point);
    }
    action.points.push_back(std::move(points));
    facing += world.rotations[0] * Vec3::UnitZ();
  }
  action.centre = 0.5 * (least + most);
  action.centre.y() = 0.0;
  Vec3 travel = clip.poses.back().root_position - clip.poses.front().root_position;
  travel.y() = 0.0;
  if (travel.norm() > travels_m) facing = travel;
  if (!motion::is_body(clip.body) && travel.norm() <= travels_m) facing = Vec3::UnitZ();
  facing.y() = 0.0;
  if (facing.norm() > 1e-9) action.forward = facing.normalized();
  return action;
}

std::vector<std::vector<Vec3>> subject_points(const motion::Clip& clip, CameraSubject subject) {
  std::vector<std::vector<Vec3>> points;
  if (subject == CameraSubject::whole_body || !motion::is_body(clip.body)) return points;
  // Joints from the neck to the head, or all but those of the legs.
  const auto is_in = [&](int joint) {
    return subject == CameraSubject::head ? joint == motion::Neck || joint == motion::Head
                                          : joint < motion::LeftHip;
  };
  for (const motion::Pose& pose : clip.poses) {
    const motion::JointTransforms world = motion::world_transforms(clip.body, pose);
    std::vector<Vec3>& frame = points.emplace_back();
    for (int joint = 0; joint < motion::body_joint_count; ++joint) {
      if (!is_in(joint)) continue;
      const auto j = static_cast<std::size_t>(joint);
      frame.push_back(world.positions[j]);
      const auto& tip = clip.body.joints[j].tip;
      if (tip) frame.push_back(world.positions[j] + world.rotations[j] * *tip);
    }
  }
  return points;
}

CameraRig make_camera_rig(const CameraSettings& settings, const Action& action,
                          std::array<int, 2> size) {
  // A screen is as wide as both pictures of a pair.
  Lens lens = lens_of(settings, size);
  if (settings.stereo_separation_m) lens.size[0] /= 2;
  CameraRig rig = !settings.path.empty() ? on_path(settings, action, lens)
                  : settings.position && settings.target
                      ? standing(at(action, *settings.position), at(action, *settings.target), lens)
                      : viewed(settings.view, action, lens);
  if (settings.screen && settings.path.empty() && !settings.position) {
    step_to(rig, settings.view, action, eye_distance_m(*settings.screen, action.height_m));
  }
  const Vec3 beside = settings.view == "follow" && settings.path.empty() && !settings.position
                          ? smooth_path(action, smoothing).front()
                          : action.centre;
  rig.figure_height_m = action.height_m;
  rig.figure_floor = beside;
  rig.figure_distance_m = depth_of(rig.cameras.front(), beside, action.height_m);
  if (settings.figure_px) magnify(rig, *settings.figure_px / figure_pixels(rig));
  if (settings.depth_of_field) open_aperture(rig, *settings.depth_of_field, action);
  if (settings.stereo_separation_m) {
    rig.stereo_separation_m = *settings.stereo_separation_m;
    rig.convergence_m = std::max(rig.figure_distance_m, 0.1);
  }
  return rig;
}

double figure_pixels(const CameraRig& rig) {
  const render::Camera& camera = rig.cameras.front();
  const double metres_a_pixel = static_cast<double>(render::frame_of(camera).step_down.norm());
  if (camera.parallel_height > 0.0f) return rig.figure_height_m / metres_a_pixel;
  const double distance = rig.figure_distance_m;
  return distance > 0.0 ? rig.figure_height_m / (distance * metres_a_pixel) : 0.0;
}

double visual_degrees(const CameraRig& rig) {
  const double distance = rig.figure_distance_m;
  if (distance <= 0.0) return 0.0;
  return 2.0 * std::atan(0.5 * rig.figure_height_m / distance) / motion::radians_per_degree;
}

double eye_distance_m(const ScreenSettings& screen, double height_m) {
  if (!screen.degrees) return 0.01 * screen.distance_cm;
  return 0.5 * height_m / std::tan(0.5 * *screen.degrees * motion::radians_per_degree);
}

}  // namespace mien::scenes
