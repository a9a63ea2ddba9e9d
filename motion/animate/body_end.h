#pragma once

#include <array>
#include <string_view>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// A part of the body that an animator places.
enum class BodyEnd { left_hand, right_hand, left_foot, right_foot, head, pelvis };

inline constexpr std::array<BodyEnd, 6> body_ends = {BodyEnd::left_hand, BodyEnd::right_hand,
                                                     BodyEnd::left_foot, BodyEnd::right_foot,
                                                     BodyEnd::head,      BodyEnd::pelvis};

/// "left hand", for sentences.
std::string_view name_of(BodyEnd end);

/// The joint that turns with it: wrist, ankle, head or pelvis.
BodyJoint joint_of(BodyEnd end);

/// The point that is placed, in the frame of `joint_of`, metres: the middle of the hand (half-way
/// from the wrist to the finger tips), the sole below the middle between heel and ball of the foot,
/// the head at the height of the eyes (half-way to its top), the pelvis joint itself.
Vec3 point_of(const Skeleton& body, BodyEnd end);

/// Where that point is, room, metres.
Vec3 place_of(const Skeleton& body, const JointTransforms& world, BodyEnd end);

/// The frame in which places are given.
enum class PlaceFrame {
  body,    ///< on the floor below the pelvis; +X to the body's left, +Y up, +Z to its front
  room,    ///< that of the motion: +Y up, the floor at y = 0
  motion,  ///< from where the motion has the part itself, along the axes of `body`
};

/// The frame `body` of a pose: the heading of the pelvis, at the height of the floor (y = 0).
struct BodyFrame {
  Vec3 origin = Vec3::Zero();
  Quat turn = Quat::Identity();  ///< body → room

  Vec3 to_room(const Vec3& place) const { return origin + turn * place; }
  Vec3 from_room(const Vec3& place) const { return turn.conjugate() * (place - origin); }
};

BodyFrame body_frame(const Pose& pose);

}  // namespace mien::motion
