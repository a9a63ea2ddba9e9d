#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A motion prepared for blending: its mean direction (straighten.h) is +Z, it starts at its first
/// keytime, and its keytimes correspond between examples.
struct Example {
  std::string name;              ///< referenced by ratings and weights: "normal", "sad_002", …
  Clip clip;                     ///< one cycle if it loops, as in walking; otherwise a whole motion
  std::vector<double> keytimes;  ///< seconds, ascending, first 0, last the clip's duration
};

/// Examples with the same number of keytimes, on one body; or, if they are not `blendable`, each
/// with its own body and keytimes.
struct ExampleSet {
  std::string name;
  std::vector<Example> examples;
  bool simulated = false;  ///< made by the parametric walker, not captured
  bool blendable = true;
};

}  // namespace mien::motion
