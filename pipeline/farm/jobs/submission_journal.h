#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/slurm/batch_script.h"

namespace mien::pipeline {

/// What is known of a job that was submitted, or was to be.
struct JournalJob {
  std::string submission;  ///< "0001"
  std::string name;        ///< "2-frames"
  std::string comment;     ///< tells Slurm's jobs of this study from all others
  int elements = 0;        ///< of its array; 0: a job that is none
  std::string memory;      ///< that was asked for
  std::string job;         ///< Slurm's; empty: nobody knows whether it was accepted
  std::string when;        ///< of the intent, in UTC: "2026-11-23T09:30:00Z"
  bool was_refused = false;
  bool was_cancelled = false;
};

/// What a submission was asked for, so that `resume` asks for the same.
struct JournalSubmission {
  std::string number;
  std::string when;
  std::string quality;
  int chunk_frames = 0;
  JobRequest request;
};

/// What was submitted for a study, in order.
struct JournalContent {
  std::vector<JournalSubmission> submissions;
  std::vector<JournalJob> jobs;
};

/// The file farm/journal.jsonl of a study: what was to be submitted, written and flushed to disk
/// before Slurm is asked, and the job it gave, afterwards. So a client that is killed in between,
/// and a controller that forgets a job or gives its number to another one, are both noticed.
///
/// Only ever appended to; a line that was cut off by a crash, or damaged, is passed over.
class SubmissionJournal {
 public:
  /// `folder`: the study's.
  explicit SubmissionJournal(const std::filesystem::path& folder);

  const std::filesystem::path& file() const { return file_; }
  JournalContent read() const;

  /// Each throws WriteFailure when the line cannot be written. A submission is noted with what is
  /// to be submitted of it, in one write.
  void note_submission(const JournalSubmission& submission,
                       const std::vector<JournalJob>& intents = {}) const;
  void note_job(const std::string& comment, const std::string& job) const;
  void note_refusal(const std::string& comment, const std::string& why) const;
  void note_cancel(const std::string& comment, const std::string& job) const;

 private:
  void append(const std::string& lines) const;

  std::filesystem::path file_;
};

/// The time now as the journal writes it.
std::string utc_now();

}  // namespace mien::pipeline
