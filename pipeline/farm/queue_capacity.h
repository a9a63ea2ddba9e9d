#pragma once

#include <functional>
#include <string>

#include "pipeline/farm/stages.h"
#include "pipeline/farm/submission.h"

namespace mien::pipeline {

/// Slurm's limit on the number of jobs of all users; each element of an array counts as one job.
struct QueueCapacity {
  int limit = 0;  ///< MaxJobCount, one more than the jobs that Slurm accepts; 0 if unknown
  int used = 0;   ///< jobs in the queue now, including recently ended ones

  bool has_capacity_for(int jobs) const { return limit == 0 || used + jobs < limit; }
};

/// A submission that fits into Slurm's queue, and the chunk sizes used for it.
struct FittingSubmission {
  Submission submission;
  Chunking chunking;
};

/// Splits a study into a submission; `cut` builds the submission for given chunk sizes. If it has
/// too many jobs for Slurm's queue and `requested` does not set the number of frames per chunk,
/// elements are lengthened up to `longest_seconds`. If there are still too many jobs, throws Error,
/// with a value of --chunk that fits if one is found; but if only the final job for the remaining
/// tasks is to be submitted, the submission is returned nevertheless.
FittingSubmission fitting_submission(const std::function<Submission(const Chunking&)>& cut,
                                     const Chunking& requested, double longest_seconds,
                                     const QueueCapacity& capacity);

/// Maximum duration in seconds to which an element may be extended: one hour, or half of its time
/// limit ("90" minutes, "1:30:00", "1-12") if that is shorter.
double longest_element_seconds(const std::string& time_limit);

}  // namespace mien::pipeline
