#pragma once

#include <array>
#include <string_view>

#include "motion/math/geometry.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// The canonical body: pelvis (the root) and the 20 joints that eq. (8) of the adjective paper sums
/// over.
///
/// At rest (all rotations are the identity) it stands in a T-pose facing +Z with +Y up: the left
/// arm along +X, the right along −X, palms down, legs along −Y, feet along +Z. At rest every
/// joint's frame is parallel to the world's, so rotations have the same meaning for all subjects,
/// whatever rig they were captured with.
enum BodyJoint : int {
  Pelvis,
  Spine,
  Chest,
  Neck,
  Head,
  LeftClavicle,
  LeftShoulder,
  LeftElbow,
  LeftWrist,
  RightClavicle,
  RightShoulder,
  RightElbow,
  RightWrist,
  LeftHip,
  LeftKnee,
  LeftAnkle,
  LeftToe,
  RightHip,
  RightKnee,
  RightAnkle,
  RightToe,
};

inline constexpr int body_joint_count = 21;

/// Names as they appear in files and tables: "Pelvis", "LeftShoulder", …
std::string_view name_of(BodyJoint joint);
std::string_view japanese_name_of(BodyJoint joint);

/// Parent of each joint; −1 for the pelvis.
inline constexpr std::array<int, body_joint_count> body_parents = {
    -1,           Pelvis,    Spine,     Chest,         Neck,          Chest,      LeftClavicle,
    LeftShoulder, LeftElbow, Chest,     RightClavicle, RightShoulder, RightElbow, Pelvis,
    LeftHip,      LeftKnee,  LeftAnkle, Pelvis,        RightHip,      RightKnee,  RightAnkle};

/// The joint on the other side of the body; a joint on the midline is its own mirror image.
BodyJoint mirrored(BodyJoint joint);

bool is_left(BodyJoint joint);
bool is_right(BodyJoint joint);

/// Unit direction, at rest, of the bone from the joint to its main child or its tip; horizontal for
/// the ankles.
Vec3 rest_direction(BodyJoint joint);

/// A body of average adult proportions (de Leva 1996 segment lengths, male), scaled to `height_m`.
Skeleton standard_body(double height_m = 1.75);

/// A body of average female proportions: narrower shoulders and wider hips than `standard_body`,
/// with otherwise the same segment lengths relative to stature (de Leva 1996: these differ by less
/// than 1 % of stature).
Skeleton standard_female_body(double height_m = 1.65);

/// Whether the skeleton has the canonical joints in canonical order.
bool is_body(const Skeleton& skeleton);

/// Thigh plus shank, mean of both sides, metres.
double leg_length(const Skeleton& body);

/// Height of the top of the head above the lowest joint or tip when standing at rest, metres. A
/// skeleton has no sole, so this is less than the stature by the sole's depth (sole.h).
double standing_height(const Skeleton& body);

/// Stature relative to `standard_body()` (1.75 m): the factor by which to scale lengths given for
/// 1.75 m.
double relative_stature(const Skeleton& body);

}  // namespace mien::motion
