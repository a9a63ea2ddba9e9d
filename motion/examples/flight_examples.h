#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// If all examples are cycles of running, replaces their keytimes by those of running, which
/// include the beginnings and ends of flight phases (gait/flight_keytimes.h), and returns true.
/// Otherwise changes nothing: runs correspond to walks by the keytimes of walking.
bool use_flight_keytimes(std::vector<Example>& examples);

/// Gives the cycles of two motions that were prepared independently corresponding keytimes: those
/// of running if both run, otherwise those of walking. Changes nothing if neither runs.
void match_keytimes(Example& a, Example& b);

/// The names of the examples that run, in the order of `examples`.
std::vector<std::string> running_examples(const std::vector<Example>& examples);

}  // namespace mien::motion
