#pragma once

#include "motion/gait/contact.h"

namespace mien::motion {

/// Contact for determining when feet meet and leave the floor, also in running, where they rest for
/// less than a tenth of a second and never quite stand still.
inline ContactOptions event_contact() {
  ContactOptions options;
  options.on_speed = 0.4;
  options.off_speed = 0.6;
  options.shortest_plant = 0.05;
  return options;
}

}  // namespace mien::motion
