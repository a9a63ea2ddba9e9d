#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/slurm/batch_script.h"

namespace mien::pipeline {

/// A job that was submitted, or was about to be.
struct JournalJob {
  std::string submission;  ///< "0001"
  std::string name;        ///< "2-frames"
  std::string comment;     ///< identifies the job among all of Slurm's jobs
  int elements = 0;        ///< size of its array; 0: not an array
  std::string memory;      ///< requested memory: "4G"
  std::string job;         ///< Slurm's job ID; empty if no answer of Slurm with an ID was recorded
  std::string when;        ///< time at which the intent was recorded, UTC: "2026-11-23T09:30:00Z"
  bool was_refused = false;
  bool was_cancelled = false;
};

/// Options of a submission, reused by `resume`.
struct JournalSubmission {
  std::string number;
  std::string when;
  std::string quality;
  int chunk_frames = 0;
  JobRequest request;
};

/// All submissions and jobs of a study, in order of submission.
struct JournalContent {
  std::vector<JournalSubmission> submissions;
  std::vector<JournalJob> jobs;
};

/// The file farm/journal.jsonl of a study, a write-ahead log of submissions: the intended jobs are
/// flushed to disk before Slurm is called, and the job IDs it returns are added afterwards.
/// This makes it possible to detect a client that was killed in between, and a controller that lost
/// a job or reused its ID.
///
/// The file is only appended to; truncated or damaged lines are ignored.
class SubmissionJournal {
 public:
  /// `folder`: the study's.
  explicit SubmissionJournal(const std::filesystem::path& folder);

  const std::filesystem::path& file() const { return file_; }
  JournalContent read() const;

  /// These functions append entries. Each throws WriteFailure if the entry cannot be written. A
  /// submission is recorded together with its intended jobs in a single write.
  void note_submission(const JournalSubmission& submission,
                       const std::vector<JournalJob>& intents = {}) const;
  void note_job(const std::string& comment, const std::string& job) const;
  void note_refusal(const std::string& comment, const std::string& why) const;
  void note_cancel(const std::string& comment, const std::string& job) const;

 private:
  void append(const std::string& lines) const;

  std::filesystem::path file_;
};

/// The current time in UTC in the journal's format: "2026-11-23T09:30:00Z".
std::string utc_now();

}  // namespace mien::pipeline
