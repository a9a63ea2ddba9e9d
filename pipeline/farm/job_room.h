#pragma once

#include <functional>
#include <string>

#include "pipeline/farm/stages.h"
#include "pipeline/farm/submission.h"

namespace mien::pipeline {

/// How many jobs Slurm takes at a time, of everybody; an element of an array counts as one.
struct JobRoom {
  int most = 0;   ///< MaxJobCount; 0: not known
  int taken = 0;  ///< that it has now, those that ended some minutes ago too

  bool has_room_for(int jobs) const { return most == 0 || taken + jobs < most; }
};

/// A submission for which Slurm has room, and into how large pieces it is cut.
struct FittingSubmission {
  Submission submission;
  Cutting cutting;
};

/// Cuts a study as is asked; `cut` gives the submission of a cutting. Where Slurm has no room for
/// so many jobs and no number of frames is asked for, elements become longer, but no longer than
/// `longest_seconds`. Throws Error, with a --chunk that fits, when there is no room all the same,
/// unless nothing but the job for what is left is to be submitted.
FittingSubmission fitting_submission(const std::function<Submission(const Cutting&)>& cut,
                                     const Cutting& asked, double longest_seconds,
                                     const JobRoom& room);

/// Seconds that an element may be made to last: an hour, or half of its time limit ("90" minutes,
/// "1:30:00", "1-12") where that is less.
double longest_element_seconds(const std::string& time_limit);

}  // namespace mien::pipeline
