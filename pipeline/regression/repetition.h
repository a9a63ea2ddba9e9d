#pragma once

#include "pipeline/regression/comparer.h"

namespace mien::pipeline {

/// What came of making everything several times: must be nothing.
struct Repetitions {
  int times = 1;         ///< that everything was made
  int differing = 0;     ///< motions and key frames that came out otherwise
  double largest = 0.0;  ///< difference of their channels, as share of full scale
};

/// Makes all motions and key frames of the baseline's stimuli anew, each time with one thread more
/// (as many as there are processors, then one again), and compares them bit by bit. Once: does
/// nothing. Throws Error and Interrupted.
Repetitions repeated(const ComparedStudy& study, int times);

}  // namespace mien::pipeline
