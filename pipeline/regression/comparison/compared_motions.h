#pragma once

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/measures/differences/motion_tolerance.h"

namespace mien::pipeline {

/// Two motions, how they differ and what of it is too much.
struct ComparedMotions {
  std::string before;  ///< files
  std::string now;
  std::string take_before;  ///< where the file holds several
  std::string take_now;     ///< where the file holds several
  motion::MotionDifference difference;
  motion::MotionTolerance tolerance;
  std::vector<motion::Excess> excesses;

  bool are_alike() const { return excesses.empty(); }
};

/// Reads two motion files, as they are, and compares them; features as `mien motion features` has
/// them; of files with several motions the takes of these names, or their first where a name is
/// empty. Throws Error for what cannot be read or compared.
ComparedMotions compared_motion_files(const std::string& before, const std::string& now,
                                      const motion::MotionTolerance& tolerance,
                                      const std::array<std::string, 2>& takes = {});

/// For people: a verdict, the largest change in a sentence, then level by level; centimetres and
/// degrees. Ends with a newline.
std::string as_text(const ComparedMotions& motions);

/// All that is known, in metres, radians and seconds, with curves a joint.
nlohmann::ordered_json as_json(const ComparedMotions& motions);

}  // namespace mien::pipeline
