#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A motion prepared for blending: walks along +Z, starts at its first keytime, and marks the
/// moments that correspond between examples.
struct Example {
  std::string name;              ///< used by ratings and weights: "normal", "sad_002", …
  Clip clip;                     ///< loops for gait; one performance otherwise
  std::vector<double> keytimes;  ///< seconds, ascending, first 0, last the clip's duration
};

/// Examples with the same number of keytimes, on one body; or, when they are not to be blended,
/// each on its own body with keytimes of its own.
struct ExampleSet {
  std::string name;
  std::vector<Example> examples;
  bool simulated = false;  ///< made by the parametric walker, not captured
  bool blendable = true;
};

}  // namespace mien::motion
