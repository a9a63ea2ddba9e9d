#include "motion/live/live_modification.h"

#include <cassert>

#include "motion/modify/modified_example.h"

namespace mien::motion {

namespace {

/// Adds the value of a dimension that is not a strength.
void add_value(Modification& all, const ModificationDimension& dimension, double value) {
  switch (dimension.value) {
    case ModificationValue::strength:
      break;
    case ModificationValue::rotation:
      all.posture.push_back({dimension.unit, value});
      break;
    case ModificationValue::paths:
      all.paths = value;
      break;
    case ModificationValue::acceleration:
      all.acceleration = value;
      break;
    case ModificationValue::tempo:
      all.tempo = value;
      break;
  }
}

}  // namespace

double neutral_value(ModificationValue value) {
  return value == ModificationValue::paths || value == ModificationValue::tempo ? 1.0 : 0.0;
}

Example modified_at(const Example& original, const LiveModification& by,
                    const std::vector<double>& point) {
  assert(point.size() == by.dimensions.size());
  Example motion = original;
  Modification others;
  for (std::size_t i = 0; i < by.dimensions.size(); ++i) {
    const ModificationDimension& dimension = by.dimensions[i];
    add_value(others, dimension, point[i]);
    if (dimension.value != ModificationValue::strength || point[i] <= 0.0) continue;
    const Modification asked =
        without_idle_gesture(scaled(dimension.recipe, point[i]), motion.clip);
    motion = modified_example(motion, asked).example;
  }
  if (!is_identity(others)) motion = modified_example(motion, others).example;
  return motion;
}

}  // namespace mien::motion
