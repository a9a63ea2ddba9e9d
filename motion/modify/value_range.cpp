#include "motion/modify/value_range.h"

#include <cstdio>

#include "motion/error.h"

namespace mien::motion {

void check_range(const std::string& name, double value, double least, double most) {
  if (value >= least && value <= most) return;
  char found[32];
  char remedy[96];
  std::snprintf(found, sizeof found, "%g", value);
  std::snprintf(remedy, sizeof remedy, "give a number from %g to %g", least, most);
  throw Error(name + " is " + found, remedy);
}

}  // namespace mien::motion
