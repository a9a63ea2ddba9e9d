#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/modify/gesture_change.h"
#include "motion/modify/relative_change.h"
#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// `range: {elbow-flexion: 0.2}`: a share given here replaces the recipe's share of the same name.
struct RangeForm {
  static void read(const DocumentValue& given, std::vector<motion::RangeShare>& range);
  static nlohmann::ordered_json write(const std::vector<motion::RangeShare>& range,
                                      const WritingOptions&);
  static void walk(auto& names) {
    for (const motion::PostureUnitName& unit : motion::posture_units()) {
      if (motion::range_of(unit.unit)) names.add(std::string(unit.name));
    }
  }
};

/// `gesture: {height: 1.2, repetitions: 1}`: a number given here replaces the recipe's of the same
/// name.
struct GestureForm {
  static void read(const DocumentValue& given, motion::GestureChange& gesture);
  static nlohmann::ordered_json write(const motion::GestureChange& gesture, const WritingOptions&);
  static void walk(auto& names) {
    for (const char* name : {"height", "width", "speed", "repetitions"}) names.add(name);
  }
};

/// The keys of a change in the actor's own terms, which stand beside the others of `modify:`.
void relative_fields(auto&& field, MaybeConst<motion::RelativeChange> auto& change) {
  field("step_width", change.step_width, concerns::motion);
  field("step_length", change.step_length, concerns::motion);
  field("sway", change.sway, concerns::motion);
  field("arm_swing", change.arm_swing, concerns::motion);
  field("trunk_swing", change.trunk_swing, concerns::motion);
  field.by("range", change.range, concerns::motion, RangeForm());
}

}  // namespace mien::pipeline
