#pragma once

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/formats/reading/read_options.h"
#include "motion/measures/differences/motion_tolerance.h"

namespace mien::pipeline {

/// Two motions, their differences and the exceeded tolerances.
struct ComparedMotions {
  std::string before;  ///< path of the file
  std::string now;
  std::string take_before;    ///< set if the file holds several takes
  std::string take_now;       ///< set if the file holds several takes
  std::string person_before;  ///< set if the file holds several people
  std::string person_now;     ///< set if the file holds several people
  motion::MotionDifference difference;
  motion::MotionTolerance tolerance;
  std::vector<motion::Excess> excesses;

  bool are_alike() const { return excesses.empty(); }
};

/// Reads two motion files and compares the motions as stored, without foot locking, alignment or
/// rotation; their features are those of `mien motion features`. `how` selects takes and people of
/// each file. Throws Error for files that cannot be read or compared.
ComparedMotions compared_motion_files(const std::string& before, const std::string& now,
                                      const motion::MotionTolerance& tolerance,
                                      const std::array<motion::ReadOptions, 2>& how = {});

/// Returns readable text: a verdict, the largest change in one sentence, then the changes level by
/// level, in centimetres and degrees. Ends with a newline.
std::string as_text(const ComparedMotions& motions);

/// Returns all differences in metres, radians and seconds.
nlohmann::ordered_json as_json(const ComparedMotions& motions);

}  // namespace mien::pipeline
