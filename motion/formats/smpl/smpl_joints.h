#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Whether SMPL or one of its relatives has so many joints: 22 (the body alone), 24 (SMPL), 52
/// (SMPL-H, with fingers), 55 (SMPL-X, with fingers, jaw and eyes).
bool is_smpl_joint_count(std::size_t joints);

/// "SMPL-H" for 52; "SMPL body" for 22.
std::string_view smpl_layout_name(std::size_t joints);

/// The joints by their names in the SMPL family, in the order of the rotations, with their parents:
/// 0 to 21 from "pelvis" to "right_wrist" in all; then "left_hand" and "right_hand" (SMPL), or
/// "left_index1" to "left_thumb3" and the same on the right (SMPL-H), these preceded by "jaw",
/// "left_eye" and "right_eye" in SMPL-X. `joints` is one of the counts above.
///
/// Offsets are those of mien's own standard body, 1.75 m tall, and not of an SMPL model: at rest it
/// stands in a T-pose, +Y up, facing +Z, left +X, as SMPL's zero pose does. The spine from Spine to
/// Chest is divided equally by spine2; lengths of the fingers, which that body does not have, and
/// places of jaw and eyes are rounded numbers of ours that fit its hand of 0.17 m and its head.
Skeleton smpl_skeleton(std::size_t joints);

/// Index of a finger joint (hand.h) in `smpl_skeleton(52)`.
int smplh_joint_of_finger(int finger_joint);

/// Index of a canonical joint (body.h) in `smpl_skeleton`; Chest is spine3, Spine is spine1.
int smpl_joint_of(int body_joint);

}  // namespace mien::motion
