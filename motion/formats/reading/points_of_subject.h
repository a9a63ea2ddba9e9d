#pragma once

#include "motion/error.h"
#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Where all points are named "subject:point" (people, or marker sets of objects): keeps those of
/// the subject that the options name, or that all have, under their short names. With several
/// subjects and none chosen, all points are kept under their full names, with a note. Throws
/// mien::Error if the options name a subject that is not there.
void keep_points_of_subject(PointRecording& recording, const ReadOptions& options,
                            const Place& place);

}  // namespace mien::motion
