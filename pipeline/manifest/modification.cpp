#include "pipeline/manifest/modification.h"

#include <algorithm>

namespace mien::pipeline {

namespace {

template <class Value>
void overlay(const std::optional<Value>& given, Value& target) {
  if (given) target = *given;
}

void overlay(const std::vector<motion::PostureChange>& given,
             std::vector<motion::PostureChange>& posture) {
  for (const motion::PostureChange& change : given) {
    const auto same = std::find_if(posture.begin(), posture.end(),
                                   [&](const auto& other) { return other.unit == change.unit; });
    if (same == posture.end()) {
      posture.push_back(change);
    } else {
      *same = change;
    }
  }
}

}  // namespace

motion::Modification with_edit(motion::Modification modification, const ModificationEdit& edit) {
  overlay(edit.paths, modification.paths);
  if (edit.paths) modification.gains.reset();
  if (edit.gains) modification.gains = edit.gains;
  overlay(edit.signal, modification.signal);
  overlay(edit.acceleration, modification.acceleration);
  overlay(edit.acceleration_place, modification.acceleration_place);
  overlay(edit.limbs, modification.limbs);
  overlay(edit.posture, modification.posture);
  overlay(edit.tempo, modification.tempo);
  overlay(edit.variation, modification.variation);
  overlay(edit.seed, modification.seed);
  overlay(edit.repair, modification.repair);
  overlay(edit.soft_limits, modification.soft_joint_limits);
  return modification;
}

std::string_view name_of(OnFault choice) {
  switch (choice) {
    case OnFault::warn:
      return "warn";
    case OnFault::fail:
      return "fail";
    case OnFault::revert:
      return "revert";
    case OnFault::reduce:
      break;
  }
  return "reduce";
}

}  // namespace mien::pipeline
