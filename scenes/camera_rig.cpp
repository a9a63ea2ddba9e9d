#include "scenes/camera_rig.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/error.h"
#include "motion/rotation.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr double vertical_field_of_view = 26.0 * motion::radians_per_degree;
constexpr double filled_share = 0.88;  // of the picture, the rest is air
constexpr double travels_m = 0.5;

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

/// The camera in that direction from which all points, as spheres of `margin`, fill the picture.
/// Each side plane of the view pyramid touches the outermost sphere, so distance and shift follow
/// from the four extremes without a search.
render::Camera framing(const std::vector<Vec3>& points, double margin, const Vec3& towards,
                       std::array<int, 2> size) {
  const Vec3 right = Vec3::UnitY().cross(towards).normalized();
  const Vec3 up = towards.cross(right);
  const double tan_up = filled_share * std::tan(0.5 * vertical_field_of_view);
  const double tan_right = tan_up * size[0] / size[1];
  const double infinity = std::numeric_limits<double>::infinity();
  double most_right = -infinity, most_left = -infinity, most_up = -infinity, most_down = -infinity;
  for (const Vec3& point : points) {
    const double x = point.dot(right);
    const double y = point.dot(up);
    const double z = point.dot(towards);
    const double reach_right = tan_right * z + margin * std::hypot(1.0, tan_right);
    const double reach_up = tan_up * z + margin * std::hypot(1.0, tan_up);
    most_right = std::max(most_right, x + reach_right);
    most_left = std::max(most_left, -x + reach_right);
    most_up = std::max(most_up, y + reach_up);
    most_down = std::max(most_down, -y + reach_up);
  }
  const double along = std::max((most_right + most_left) / (2.0 * tan_right),
                                (most_up + most_down) / (2.0 * tan_up));
  const Vec3 position =
      0.5 * (most_right - most_left) * right + 0.5 * (most_up - most_down) * up + along * towards;
  render::Camera camera;
  camera.position = position.cast<float>();
  camera.target = (position - towards).cast<float>();
  camera.vertical_field_of_view = static_cast<float>(vertical_field_of_view);
  camera.width = size[0];
  camera.height = size[1];
  return camera;
}

std::vector<Vec3> all_points(const Action& action) {
  std::vector<Vec3> all;
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

CameraRig follow(const Action& action, const Vec3& towards, std::array<int, 2> size) {
  const std::vector<Vec3> path = smooth_path(action, 15);
  std::vector<Vec3> beside;
  for (size_t f = 0; f < action.points.size(); ++f) {
    for (const Vec3& point : action.points[f]) {
      beside.push_back(point - path[f]);
      beside.emplace_back(point.x() - path[f].x(), 0.0, point.z() - path[f].z());
    }
  }
  const render::Camera still = framing(beside, action.margin_m, towards, size);
  CameraRig rig;
  for (const Vec3& shift : path) {
    rig.cameras.push_back(still);
    rig.cameras.back().position += shift.cast<float>();
    rig.cameras.back().target += shift.cast<float>();
  }
  return rig;
}

CameraRig orbit(const Action& action, std::array<int, 2> size) {
  // The action as a cylinder: its framing is the same from all sides, so the figure keeps its size.
  double radius = 0.0;
  double height = 0.0;
  for (const auto& frame : action.points) {
    for (const Vec3& point : frame) {
      radius = std::max(radius,
                        std::hypot(point.x() - action.centre.x(), point.z() - action.centre.z()));
      height = std::max(height, point.y());
    }
  }
  std::vector<Vec3> rim;
  for (int k = 0; k < 32; ++k) {
    const double turn = 2.0 * motion::pi * k / 32;
    const Vec3 out(radius * std::sin(turn), 0.0, radius * std::cos(turn));
    rim.push_back(out);
    rim.push_back(out + Vec3(0.0, height, 0.0));
  }
  const Viewpoint start = viewpoint_of("three-quarter");
  const render::Camera still =
      framing(rim, action.margin_m, towards_camera({0.0, start.elevation}, Vec3::UnitZ()), size);
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

}  // namespace

std::vector<std::string> camera_names() {
  return {"front", "side", "three-quarter", "follow", "orbit"};
}

Action action_of(const motion::Clip& clip) {
  Action action;
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

CameraRig make_camera_rig(const CameraSettings& settings, const Action& action,
                          std::array<int, 2> size) {
  const std::string& name = settings.view;
  const std::vector<std::string> names = camera_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw Error("there is no camera \"" + name + "\"",
                "choose front, side, three-quarter, follow or orbit");
  }
  if (name == "orbit") return orbit(action, size);
  const Vec3 towards = towards_camera(viewpoint_of(name), action.forward);
  if (name == "follow") return follow(action, towards, size);
  return {{framing(all_points(action), action.margin_m, towards, size)}};
}

}  // namespace mien::scenes
