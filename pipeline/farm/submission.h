#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/submission_journal.h"
#include "pipeline/farm/slurm/batch_script.h"
#include "pipeline/farm/slurm/slurm.h"
#include "pipeline/farm/stages.h"

namespace mien::pipeline {

/// A batch file and the items of its elements, one line an element.
struct SubmissionJob {
  BatchJob job;
  JobRequest request;
  std::vector<Element> elements;  ///< none: the job that makes what is left
};

/// Job arrays that may run at the same time.
struct SubmissionStage {
  int place = 0;  ///< 1 motions, 2 frames, 3 films, 4 sheets, 5 study, 6 what is left
  std::vector<SubmissionJob> jobs;
};

/// What is handed to Slurm in one go. Jobs of a stage wait for those of the stage before, the last
/// one for all; they wait for their end only, because a job makes what it needs itself if a job
/// before it failed.
struct Submission {
  JournalSubmission asked;
  std::filesystem::path folder;  ///< out/<study>/farm/0001, absolute
  StudyCall call;
  SlurmSite site;
  std::vector<SubmissionStage> stages;  ///< the last one makes what is left

  int elements() const;
  /// That Slurm counts: elements, and the job that makes what is left.
  int jobs() const { return elements() + 1; }
};

/// What a study's items need beyond what is asked for.
struct ItemNeeds {
  std::set<std::string> covered;              ///< items that live jobs make already
  std::map<std::string, std::string> memory;  ///< by task, where a job ran out of it
};

/// "0004" after three submissions; the first number that neither a folder of `farm` has nor the
/// journal.
std::string next_submission(const std::filesystem::path& study_folder);

/// The name under which Slurm's jobs are known as this study's: of its tasks, all that determines
/// them, and the folder that they are made in.
std::string graph_key(const TaskGraph& graph, const std::filesystem::path& study_folder);

/// Puts stages into job arrays as large as the site takes, and the job for what is left behind
/// them.
Submission submission_of(const std::vector<Stage>& stages, const ItemNeeds& needs,
                         const std::string& graph_key, JournalSubmission asked,
                         const std::filesystem::path& study_folder, const StudyCall& call,
                         const SlurmSite& site);

/// The text of a job's batch file and of the list that it reads.
std::string script_text(const Submission& submission, const SubmissionJob& job);
std::string list_text(const SubmissionJob& job);

/// Makes the submission's folder with all files and notes in the journal what is to be submitted:
/// all that is written before Slurm is asked for anything, so that on a disk that is full nothing
/// is taken back or submitted. Throws what writing throws, and std::runtime_error when another
/// client has made a folder of that number in the meantime; then no folder stays.
void write_submission(const Submission& submission, const SubmissionJournal& journal);

/// Of a written submission that is not to be: notes in the journal, where that can be written, why,
/// and removes the folder unless one of its jobs had begun.
void withdraw(const Submission& submission, const SubmissionJournal& journal,
              const std::string& why);

/// A job that Slurm has taken.
struct SubmittedJob {
  std::string name;  ///< "2-frames"
  std::string job;   ///< Slurm's
  int elements = 0;
};

/// What Slurm has taken of a submission.
struct Submitted {
  std::vector<SubmittedJob> jobs;
  std::string unnoted;  ///< why the journal lacks a job's number; empty when it has all
};

/// Hands a written submission to Slurm. Films and what follows them wait for the jobs `live` of
/// earlier submissions too. When a job is refused, those before it are cancelled, the submission is
/// withdrawn, and SlurmFault is thrown; when Slurm's answer does not come, what it has taken stays.
Submitted submit(const Submission& submission, const Slurm& slurm, const SubmissionJournal& journal,
                 const std::vector<std::string>& live);

}  // namespace mien::pipeline
