#pragma once

#include <algorithm>

#include "motion/skeleton/sole.h"

namespace mien::motion {

/// Height of the lowest point of a sole, metres.
inline double lowest_height(const SolePoints& sole) {
  return std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()});
}

}  // namespace mien::motion
