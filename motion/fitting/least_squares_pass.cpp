#include "motion/fitting/least_squares_pass.h"

#include <algorithm>
#include <array>

#include "motion/math/linear_system.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr int usual_steps = 3;
constexpr int most_steps = 15;
constexpr double point_deviation = 0.010;   // metres
constexpr double far_point = 0.030;         // metres
constexpr double given_turn = 0.5;          // radians
constexpr double given_way = 0.5;           // metres
constexpr double least_smooth_turn = 0.02;  // radians
constexpr double acceleration = 50.0;       // rad/s², half of a fast joint's
constexpr int unknowns = 3 + 3 * body_joint_count;

using Vector = Eigen::Matrix<double, unknowns, 1>;
using Matrix = Eigen::Matrix<double, unknowns, unknowns>;

/// The normal equations of one frame. Unknowns: the root's displacement, then a small turn of each
/// joint in world space.
struct Equations {
  Matrix normal = Matrix::Zero();
  Vector right = Vector::Zero();
};

int column_of(int joint) { return 3 + 3 * joint; }

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// A point that is `error` away from where it was measured.
void add_point(const JointTransforms& world, BodyJoint joint, const Vec3& place, const Vec3& error,
               Equations& equations) {
  std::array<int, body_joint_count + 1> columns{};
  std::array<Mat3, body_joint_count + 1> slopes;
  std::size_t count = 0;
  columns[count] = 0;
  slopes[count++] = Mat3::Identity();
  for (int turning = joint; turning >= 0;
       turning = body_parents[static_cast<std::size_t>(turning)]) {
    columns[count] = column_of(turning);
    slopes[count++] = -cross_matrix(place - world.positions[static_cast<std::size_t>(turning)]);
  }
  const double near = std::min(1.0, far_point / std::max(1e-9, error.norm()));
  const double weight = near / (point_deviation * point_deviation);
  for (std::size_t i = 0; i < count; ++i) {
    equations.right.segment<3>(columns[i]) -= weight * slopes[i].transpose() * error;
    for (std::size_t k = 0; k < count; ++k) {
      equations.normal.block<3, 3>(columns[i], columns[k]) +=
          weight * slopes[i].transpose() * slopes[k];
    }
  }
}

/// Draws the pose towards another one.
void add_reference(const Skeleton& body, const JointTransforms& world, const Pose& pose,
                   const Pose& reference, double turn, double way, Equations& equations) {
  const double for_way = 1.0 / (way * way);
  equations.normal.topLeftCorner<3, 3>() += for_way * Mat3::Identity();
  equations.right.head<3>() -= for_way * (pose.root_position - reference.root_position);
  const double for_turn = 1.0 / (turn * turn);
  for (int joint = 0; joint < body_joint_count; ++joint) {
    const int parent = body.joints[joint].parent;
    Vec3 away = log(pose.rotations[joint] * reference.rotations[joint].conjugate());
    if (parent >= 0) away = world.rotations[parent] * away;
    const int column = column_of(joint);
    equations.normal.block<3, 3>(column, column) += for_turn * Mat3::Identity();
    equations.right.segment<3>(column) -= for_turn * away;
  }
}

Pose moved(const Skeleton& body, const JointTransforms& world, const Pose& pose,
           const Eigen::MatrixXd& change) {
  Pose result = pose;
  result.root_position += change.topRows<3>();
  for (int joint = 0; joint < body_joint_count; ++joint) {
    const int parent = body.joints[joint].parent;
    Vec3 turn = change.middleRows<3>(column_of(joint));
    if (parent >= 0) turn = world.rotations[parent].conjugate() * turn;
    result.rotations[joint] = (exp(turn) * pose.rotations[joint]).normalized();
  }
  return result;
}

}  // namespace

std::vector<Pose> least_squares_pass(const PointTracks& points, const Skeleton& body,
                                     std::span<const Attachment> attached,
                                     const std::vector<Pose>& poses, const FrameRange& range) {
  const double frame_seconds = 1.0 / points.recording.frames_per_second;
  const double smooth = std::max(least_smooth_turn, acceleration * frame_seconds * frame_seconds);
  std::vector<Pose> current = poses;
  std::vector<bool> is_hard(poses.size(), true);
  for (int step = 0; step < most_steps; ++step) {
    std::vector<Pose> next = current;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (!is_hard[i]) continue;
      const Pose& pose = current[i];
      const JointTransforms world = world_transforms(body, pose);
      Equations equations;
      bool is_hidden = false;
      double farthest = 0.0;
      for (const Attachment& attachment : attached) {
        const std::size_t at =
            points.recording.at(range.first + static_cast<int>(i), attachment.point);
        is_hidden = is_hidden || !points.recording.seen[at];
        if (!points.recording.seen[at]) continue;
        const Vec3 place = world.positions[attachment.joint] +
                           world.rotations[attachment.joint] * attachment.place;
        const Vec3 off = place - points.recording.positions[at];
        farthest = std::max(farthest, off.norm());
        add_point(world, attachment.joint, place, off, equations);
      }
      if (step == usual_steps) is_hard[i] = is_hidden || farthest > far_point;
      if (!is_hard[i]) continue;
      add_reference(body, world, pose, poses[i], given_turn, given_way, equations);
      if (i > 0 && i + 1 < poses.size()) {
        add_reference(body, world, pose, interpolate(current[i - 1], current[i + 1], 0.5), smooth,
                      smooth, equations);
      }
      next[i] = moved(body, world, pose, solve_symmetric(equations.normal, equations.right));
    }
    current = std::move(next);
  }
  return current;
}

}  // namespace mien::motion
