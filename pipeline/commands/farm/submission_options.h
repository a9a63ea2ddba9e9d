#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/submission.h"

namespace mien::pipeline {

/// How a study is cut and what is asked for its jobs; what nobody said is empty.
struct SubmissionOptions {
  std::string chunk;
  std::string partition;
  std::string time;
  std::string memory;
  std::string account;
  std::optional<int> array_limit;
  std::optional<int> jobs;
};

void add_submission_options(CLI::App& command, SubmissionOptions& options);

/// The options over those of an earlier submission (or over nothing). Throws Error for one that
/// makes no sense.
JournalSubmission asked_for(const SubmissionOptions& options, JournalSubmission earlier);

/// The stages of all tasks that are not in the store yet, or of all tasks there are.
std::vector<Stage> due_stages(FarmStudy& study, const JournalSubmission& asked);
std::vector<Stage> all_stages(FarmStudy& study, const JournalSubmission& asked);

/// Whether everything is there, the study's record too.
bool is_complete(const FarmStudy& study, const std::vector<Stage>& due);

/// What was submitted, and what to do next.
void tell_submitted(const Submission& submission, const std::vector<SubmittedJob>& jobs,
                    const FarmArguments& arguments, bool json, const Console& console);

/// All that a submission would be: its stages and the texts of its files.
void tell_dry_run(const Submission& submission, const Console& console);

}  // namespace mien::pipeline
