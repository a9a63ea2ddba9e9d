#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "motion/animate/body_drive.h"
#include "motion/animate/constraint.h"
#include "motion/animate/frozen_parts.h"
#include "motion/animate/keys.h"
#include "motion/animate/motion_ends.h"
#include "motion/text/words.h"
#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

inline constexpr Words<motion::PlaceFrame> place_frame_words = {
    {"body", motion::PlaceFrame::body},
    {"room", motion::PlaceFrame::room},
    {"motion", motion::PlaceFrame::motion}};

/// Parts of the body, as in keys and constraints.
inline constexpr Words<motion::BodyEnd> body_end_words = {
    {"left-hand", motion::BodyEnd::left_hand}, {"right-hand", motion::BodyEnd::right_hand},
    {"left-foot", motion::BodyEnd::left_foot}, {"right-foot", motion::BodyEnd::right_foot},
    {"head", motion::BodyEnd::head},           {"pelvis", motion::BodyEnd::pelvis}};
inline constexpr Words<motion::Stays> stays_words = {{"position", motion::Stays::position},
                                                     {"orientation", motion::Stays::orientation}};
inline constexpr Words<motion::RangeAngle> range_angle_words = {
    {"head-flexion", motion::RangeAngle::head_flexion},
    {"head-lateral", motion::RangeAngle::head_lateral},
    {"head-turn", motion::RangeAngle::head_turn},
    {"spine-flexion", motion::RangeAngle::spine_flexion},
    {"spine-lateral", motion::RangeAngle::spine_lateral},
    {"spine-turn", motion::RangeAngle::spine_turn},
    {"left-elbow-flexion", motion::RangeAngle::left_elbow_flexion},
    {"right-elbow-flexion", motion::RangeAngle::right_elbow_flexion}};

inline constexpr Words<motion::LimbMovement> limb_movement_words = {
    {"left-hand-forward", motion::LimbMovement::left_hand_forward},
    {"left-hand-side", motion::LimbMovement::left_hand_side},
    {"left-hand-height", motion::LimbMovement::left_hand_height},
    {"right-hand-forward", motion::LimbMovement::right_hand_forward},
    {"right-hand-side", motion::LimbMovement::right_hand_side},
    {"right-hand-height", motion::LimbMovement::right_hand_height}};
inline constexpr Words<motion::BodyMovement> body_movement_words = {
    {"pelvis-height", motion::BodyMovement::pelvis_height},
    {"pelvis-side", motion::BodyMovement::pelvis_side},
    {"spine-flexion", motion::BodyMovement::spine_flexion},
    {"spine-lateral", motion::BodyMovement::spine_lateral},
    {"spine-turn", motion::BodyMovement::spine_turn},
    {"left-foot-forward", motion::BodyMovement::left_foot_forward},
    {"right-foot-forward", motion::BodyMovement::right_foot_forward}};

inline constexpr Words<motion::FrozenPart> frozen_words = {
    {"legs", motion::FrozenPart::legs},
    {"trunk", motion::FrozenPart::trunk},
    {"head", motion::FrozenPart::head},
    {"left-arm", motion::FrozenPart::left_arm},
    {"right-arm", motion::FrozenPart::right_arm}};

/// `freeze: legs`, `freeze: [legs, arms]`, or `freeze: {parts: legs, at: 1.2}`; `arms` are both.
struct FreezingForm {
  static void read(const DocumentValue& given, motion::Freezing& freezing);
  static nlohmann::ordered_json write(const motion::Freezing& freezing, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("parts");
    names.add("at");
  }
};

/// `ends: loop`, or seconds for which the first and last pose stay: `ends: {before: 0.5, after:
/// 1}`.
struct EndsForm {
  static void read(const DocumentValue& given, motion::MotionEnds& ends);
  static nlohmann::ordered_json write(const motion::MotionEnds& ends, const WritingOptions&);
  static void walk(auto& names) {
    names.add("before");
    names.add("after");
  }
};

void fields_of(auto&& field, MaybeConst<motion::DriveEditing> auto& drive) {
  field("limb", drive.limb, concerns::motion | concerns::required, limb_movement_words);
  field("body", drive.body, concerns::motion | concerns::required, body_movement_words);
  field("scale", drive.scale, concerns::motion);
  field("shift", drive.shift, concerns::motion);
}

/// A moment: `1.2` or `1.2 s`, in seconds, or `frame 40`.
struct MomentForm {
  static void read(const DocumentValue& given, motion::Moment& moment);
  static nlohmann::ordered_json write(const motion::Moment& moment, const WritingOptions&);
};

/// A place: `[x, y, z]`, metres; omitted if there is none.
struct PlaceForm {
  static void read(const DocumentValue& given, std::optional<motion::Vec3>& place);
  static nlohmann::ordered_json write(const std::optional<motion::Vec3>& place,
                                      const WritingOptions&);
};

/// A moment that need not be given.
struct OptionalMomentForm {
  static void read(const DocumentValue& given, std::optional<motion::Moment>& moment);
  static nlohmann::ordered_json write(const std::optional<motion::Moment>& moment,
                                      const WritingOptions& how);
};

/// A word that need not be given.
template <class Enum, const Words<Enum>& words>
struct OptionalWordForm {
  static void read(const auto& given, std::optional<Enum>& value) {
    if (given.value.is_string()) value = meaning_of(words, given.value.template get<std::string>());
  }
  template <class Json = nlohmann::ordered_json>
  static Json write(const std::optional<Enum>& value, const auto&) {
    return value ? Json(word_of(words, *value)) : Json();
  }
};

void fields_of(auto&& field, MaybeConst<motion::AnimatorKey> auto& key) {
  const auto place = [&](const char* name, motion::BodyEnd end) {
    field.by(name, key.places[static_cast<std::size_t>(end)], concerns::motion, PlaceForm());
  };
  field.by("at", key.at, concerns::motion | concerns::required, MomentForm());
  place("left-hand", motion::BodyEnd::left_hand);
  place("right-hand", motion::BodyEnd::right_hand);
  place("left-foot", motion::BodyEnd::left_foot);
  place("right-foot", motion::BodyEnd::right_foot);
  place("pelvis", motion::BodyEnd::pelvis);
  field.by("look_at", key.look_at, concerns::motion, PlaceForm());
  field("relative", key.frame, concerns::motion, place_frame_words);
  field("reach", key.reach, concerns::motion);
}

void fields_of(auto&& field, MaybeConst<motion::PathPlace> auto& one) {
  field.by("at", one.at, concerns::motion | concerns::required, MomentForm());
  field.by("place", one.place, concerns::motion | concerns::required, PlaceForm());
}

void fields_of(auto&& field, MaybeConst<motion::MotionConstraint> auto& one) {
  using motion::BodyEnd;
  field.by("part", one.part, concerns::motion, OptionalWordForm<BodyEnd, body_end_words>());
  field.by("from", one.from, concerns::motion, OptionalMomentForm());
  field.by("to", one.to, concerns::motion, OptionalMomentForm());
  field("reach", one.reach, concerns::motion);
  field.by("relative", one.frame, concerns::motion,
           OptionalWordForm<motion::PlaceFrame, place_frame_words>());
  field.by("stays", one.stays, concerns::motion, OptionalWordForm<motion::Stays, stays_words>());
  field.by("place", one.place, concerns::motion, PlaceForm());
  field("follows", one.follows, concerns::motion);
  field.group("within", [&](auto& inner) {
    inner("x", one.within[0], concerns::motion);
    inner("y", one.within[1], concerns::motion);
    inner("z", one.within[2], concerns::motion);
  });
  field.by("distance_to", one.distance_to, concerns::motion,
           OptionalWordForm<BodyEnd, body_end_words>());
  field.by("angle", one.angle, concerns::motion,
           OptionalWordForm<motion::RangeAngle, range_angle_words>());
  field.by("look_at", one.look_at, concerns::motion, PlaceForm());
  field("at_least", one.at_least, concerns::motion);
  field("at_most", one.at_most, concerns::motion);
}

}  // namespace mien::pipeline
