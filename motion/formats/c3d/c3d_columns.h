#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/formats/c3d/c3d_parameters.h"
#include "motion/formats/reading/read_options.h"

namespace mien::motion {

/// Which of the points in a C3D file are positions of the chosen person, and what they are called.
struct C3dColumns {
  std::vector<std::string> names;     ///< all differ, none is empty
  std::vector<std::size_t> columns;   ///< of each name: its place among the points of a frame
  std::vector<std::string> subjects;  ///< people in the file
  std::string subject;                ///< the one whose points these are; empty: all
};

/// Names are those of POINT:LABELS, LABELS2, …
///
/// - Results of models that are stored among the points but are no positions are left out, with a
///   note: those that POINT:ANGLES, FORCES, MOMENTS, POWERS, SCALARS, REACTIONS and the other
///   groups of POINT:TYPE_GROUPS list, and names that end as those of Vicon's gait models do
///   ("LHipAngles", "RKneeMoment").
/// - People are those of SUBJECTS:NAMES. "Ann:" in "Ann:LASI" is a person's prefix if it is in that
///   parameter or in SUBJECTS:LABEL_PREFIXES, or is longer than a letter and borne by three points
///   or more. The prefix of the only person is removed; of several, `options.subject` chooses one,
///   by name or number, and without a choice all points are kept under their full names.
///
/// Throws mien::Error if the subject is not in the file, and if no position is left.
C3dColumns c3d_columns(const C3dFile& file, std::size_t points, const ReadOptions& options,
                       std::vector<std::string>& notes);

}  // namespace mien::motion
