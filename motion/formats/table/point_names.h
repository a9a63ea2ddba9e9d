#pragma once

#include <string>
#include <vector>

#include "motion/error.h"
#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Gives empty names a number ("point 3"), and the second of two equal names too ("nose 2"), so
/// that all differ.
std::vector<std::string> distinct_names(std::vector<std::string> names);

/// Where all points are named "subject:point" (people, or marker sets of objects): keeps those of
/// the subject that the options name, or that all have, under their short names. With several
/// subjects and none chosen, all points are kept under their full names, with a note. Throws
/// mien::Error if the options name a subject that is not there.
void split_subjects(PointRecording& recording, const ReadOptions& options, const Place& place);

}  // namespace mien::motion
