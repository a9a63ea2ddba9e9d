#include "pipeline/farm/jobs/job_problems.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/farm/jobs/diagnosis.h"
#include "pipeline/farm/jobs/submission_journal.h"
#include "pipeline/farm/jobs/task_list.h"
#include "pipeline/farm/slurm/slurm_output.h"
#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

namespace {

using Ends = std::map<std::pair<std::string, int>, ElementExit>;

/// The item without its chunk number, because the film may have been split differently since.
std::string without_number(const std::string& item) {
  return item.substr(0, std::min(item.size(), item.find('[') + 1));
}

std::string task_of(const std::string& item) { return item.substr(0, item.find('[')); }

/// Items that are missing, and the last submission that contains each.
class UnfinishedItems {
 public:
  UnfinishedItems(const std::vector<JobStatus>& statuses, const StudyState& study) : study_(study) {
    for (const JobStatus& job_status : statuses) {
      if (job_status.journal.was_refused) continue;
      newest_submission_ = std::max(newest_submission_, job_status.journal.submission);
      for (const auto& line : lines_of(job_status.journal)) {
        for (const std::string& item : line)
          last_[without_number(item)] = job_status.journal.submission;
      }
    }
  }

  bool by(const JournalJob& job, int element) {
    if (job.was_refused) return false;
    if (job.elements == 0) return !study_.is_complete && job.submission == newest_submission_;
    const auto& lines = lines_of(job);
    const auto line = static_cast<std::size_t>(element) - 1;
    return line < lines.size() &&
           std::any_of(lines[line].begin(), lines[line].end(), [&](const std::string& item) {
             return !study_.done.contains(task_of(item)) &&
                    last_.at(without_number(item)) == job.submission;
           });
  }

 private:
  const std::vector<std::vector<std::string>>& lines_of(const JournalJob& job) {
    const auto [list, is_new] = lists_.try_emplace(job.submission + "/" + job.name);
    if (is_new) list->second = lines_of_list(list_of(job, study_.folder));
    return list->second;
  }

  const StudyState& study_;
  std::string newest_submission_;
  std::map<std::string, std::string> last_;
  std::map<std::string, std::vector<std::vector<std::string>>> lists_;
};

/// Elements of a job whose last attempt is over, with the row that Slurm still has of it.
std::map<int, const QueueRow*> exited_elements(const JobStatus& job_status, const Ends& ends) {
  std::map<int, const QueueRow*> ended;
  for (const auto& [element, end] : ends) {
    if (element.first == job_status.journal.name) ended[element.second] = nullptr;
  }
  for (const QueueRow& row : job_status.rows) {
    if (row.state == "COMPLETED") continue;
    const QueueRow*& newest = ended[row.index.value_or(1)];
    if (newest == nullptr ||
        std::pair(newest->job.size(), newest->job) < std::pair(row.job.size(), row.job))
      newest = &row;
  }
  for (const QueueRow& row : job_status.live()) ended.erase(row.index.value_or(1));
  return ended;
}

std::optional<ElementExit> exit_of(const JournalJob& job, int element, const Ends& ends) {
  const auto found = ends.find({job.name, element});
  return found == ends.end() ? std::nullopt : std::optional(found->second);
}

bool was_cancelled(const JobStatus& job_status, const std::optional<ElementExit>& end,
                   const QueueRow* row) {
  if (row != nullptr) return row->state == "CANCELLED";
  const bool was_stopped = end && (end->code == worker_transient || end->code == 130);
  return job_status.journal.was_cancelled && was_stopped;
}

/// Collects the problems of jobs, submission by submission.
class ProblemFinder {
 public:
  ProblemFinder(const std::vector<JobStatus>& statuses, const StudyState& study)
      : study_(study), unfinished_(statuses, study) {}

  void examine(const JobStatus& job_status) {
    if (ends_of_ != job_status.journal.submission) {
      ends_of_ = job_status.journal.submission;
      ends_ = read_element_exits(study_.folder / "farm" / ends_of_);
    }
    const bool is_outdated =
        !job_status.journal.comment.starts_with("mien:" + study_.graph_key + ":");
    // The job that completes a submission uses the study's present state.
    const bool is_useless = is_outdated && job_status.journal.elements > 0;
    for (const QueueRow& row : job_status.live()) examine_live(job_status, row, is_useless);
    if (is_outdated) return;
    for (const auto& [element, row] : exited_elements(job_status, ends_))
      examine_ended(job_status, element, row);
  }

  std::vector<JobProblem> take() && { return std::move(problems_); }

 private:
  void examine_live(const JobStatus& job_status, const QueueRow& row, bool is_outdated) {
    if (!is_stuck(row) && !is_outdated) return;
    const int element = row.index.value_or(1);
    JobProblem problem = problem_of(job_status, element);
    problem.kind = is_stuck(row) ? JobProblem::Kind::held : JobProblem::Kind::outdated;
    problem.job = name_of(row);
    problem.reason = row.reason;
    const std::optional<ElementExit> end = exit_of(job_status.journal, element, ends_);
    // Only these codes make a job hold itself; others stem from an earlier attempt.
    const bool held_itself =
        end && (end->code == worker_wrong_setup || end->code == worker_disk_unavailable) &&
        !exceeds_partition(row);
    add(std::move(problem), is_outdated   ? diagnose_edit(study_.words)
                            : held_itself ? diagnose_exit(*end, false, study_.words)
                                          : diagnose_hold(row, study_.words));
  }

  void examine_ended(const JobStatus& job_status, int element, const QueueRow* row) {
    const std::optional<ElementExit> end = exit_of(job_status.journal, element, ends_);
    if ((!end && row == nullptr) || !unfinished_.by(job_status.journal, element)) return;
    JobProblem problem = problem_of(job_status, element);
    if (row != nullptr) problem.reason = row->reason;
    const bool is_rest = job_status.journal.elements == 0;
    // Slurm knows better than the job's shell why memory or time ran out.
    const bool slurm_knows = row != nullptr && row->state != "FAILED";
    if (was_cancelled(job_status, end, row)) {
      problem.kind = JobProblem::Kind::cancelled;
      add(std::move(problem), {"cancelled", ""});
    } else {
      add(std::move(problem), end && !slurm_knows ? diagnose_exit(*end, is_rest, study_.words)
                                                  : diagnose_state(*row, study_.words));
    }
  }

  static JobProblem problem_of(const JobStatus& job_status, int element) {
    JobProblem problem;
    problem.submission = job_status.journal.submission;
    problem.element = fmt::format("{}.{}", job_status.journal.name, element);
    problem.job = job_status.journal.job;
    if (job_status.journal.elements > 0) problem.job += fmt::format("_{}", element);
    return problem;
  }

  void add(JobProblem problem, Diagnosis words) {
    problem.cause = std::move(words.cause);
    problem.remedy = std::move(words.remedy);
    problems_.push_back(std::move(problem));
  }

  const StudyState& study_;
  UnfinishedItems unfinished_;
  std::string ends_of_;
  Ends ends_;
  std::vector<JobProblem> problems_;
};

const char* title_of(JobProblem::Kind kind) {
  constexpr const char* titles[] = {"held by Slurm", "obsolete",
                                    "unresponsive, although running according to Slurm",
                                    "ended abnormally", "cancelled"};
  return titles[static_cast<std::size_t>(kind)];
}

}  // namespace

std::vector<JobProblem> job_problems(const std::vector<JobStatus>& statuses,
                                     const StudyState& study) {
  ProblemFinder finder(statuses, study);
  for (const JobStatus& job_status : statuses) finder.examine(job_status);
  return std::move(finder).take();
}

std::string problems_text(const std::vector<JobProblem>& problems) {
  std::map<std::pair<JobProblem::Kind, std::string>, std::vector<const JobProblem*>> groups;
  for (const JobProblem& one : problems) groups[{one.kind, one.cause}].push_back(&one);
  std::string text;
  for (const auto& [kind_and_cause, group] : groups) {
    std::vector<std::string> jobs;
    for (const JobProblem* one : group) jobs.push_back(one->job);
    text +=
        fmt::format("{}: {} job{} ({})\n  {}\n", title_of(kind_and_cause.first), group.size(),
                    group.size() == 1 ? "" : "s", motion::first_of(jobs, 4), kind_and_cause.second);
    if (!group.front()->remedy.empty()) text += "  " + group.front()->remedy + "\n";
  }
  return text;
}

}  // namespace mien::pipeline
