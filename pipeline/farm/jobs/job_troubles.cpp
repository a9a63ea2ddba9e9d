#include "pipeline/farm/jobs/job_troubles.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/farm/jobs/submission_journal.h"
#include "pipeline/farm/jobs/task_list.h"
#include "pipeline/farm/jobs/trouble_words.h"
#include "pipeline/farm/slurm/slurm_answers.h"
#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

namespace {

using Ends = std::map<std::pair<std::string, int>, ElementEnd>;

/// The item without its chunk number, because the film may have been split differently since.
std::string without_number(const std::string& item) {
  return item.substr(0, std::min(item.size(), item.find('[') + 1));
}

std::string task_of(const std::string& item) { return item.substr(0, item.find('[')); }

/// Items that are missing, and the last submission that contains each.
class Undone {
 public:
  Undone(const std::vector<JobFate>& fates, const StudyState& study) : study_(study) {
    for (const JobFate& fate : fates) {
      if (fate.journal.was_refused) continue;
      newest_submission_ = std::max(newest_submission_, fate.journal.submission);
      for (const auto& line : lines_of(fate.journal)) {
        for (const std::string& item : line) last_[without_number(item)] = fate.journal.submission;
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
std::map<int, const QueueRow*> ended_elements(const JobFate& fate, const Ends& ends) {
  std::map<int, const QueueRow*> ended;
  for (const auto& [element, end] : ends) {
    if (element.first == fate.journal.name) ended[element.second] = nullptr;
  }
  for (const QueueRow& row : fate.rows) {
    if (row.state == "COMPLETED") continue;
    const QueueRow*& newest = ended[row.index.value_or(1)];
    if (newest == nullptr ||
        std::pair(newest->job.size(), newest->job) < std::pair(row.job.size(), row.job))
      newest = &row;
  }
  for (const QueueRow& row : fate.live()) ended.erase(row.index.value_or(1));
  return ended;
}

std::optional<ElementEnd> end_of(const JournalJob& job, int element, const Ends& ends) {
  const auto found = ends.find({job.name, element});
  return found == ends.end() ? std::nullopt : std::optional(found->second);
}

bool was_cancelled(const JobFate& fate, const std::optional<ElementEnd>& end, const QueueRow* row) {
  if (row != nullptr) return row->state == "CANCELLED";
  const bool was_stopped = end && (end->code == worker_transient || end->code == 130);
  return fate.journal.was_cancelled && was_stopped;
}

/// Collects the problems of jobs, submission by submission.
class TroubleFinder {
 public:
  TroubleFinder(const std::vector<JobFate>& fates, const StudyState& study)
      : study_(study), undone_(fates, study) {}

  void look_at(const JobFate& fate) {
    if (ends_of_ != fate.journal.submission) {
      ends_of_ = fate.journal.submission;
      ends_ = ends_in(study_.folder / "farm" / ends_of_);
    }
    const bool is_outdated = !fate.journal.comment.starts_with("mien:" + study_.graph_key + ":");
    // The job that completes a submission uses the study's present state.
    const bool is_useless = is_outdated && fate.journal.elements > 0;
    for (const QueueRow& row : fate.live()) look_at_live(fate, row, is_useless);
    if (is_outdated) return;
    for (const auto& [element, row] : ended_elements(fate, ends_))
      look_at_ended(fate, element, row);
  }

  std::vector<JobTrouble> take() && { return std::move(troubles_); }

 private:
  void look_at_live(const JobFate& fate, const QueueRow& row, bool is_outdated) {
    if (!is_stuck(row) && !is_outdated) return;
    const int element = row.index.value_or(1);
    JobTrouble trouble = trouble_of(fate, element);
    trouble.kind = is_stuck(row) ? JobTrouble::Kind::held : JobTrouble::Kind::outdated;
    trouble.job = name_of(row);
    trouble.reason = row.reason;
    const std::optional<ElementEnd> end = end_of(fate.journal, element, ends_);
    // Only these codes make a job hold itself; others stem from an earlier attempt.
    const bool held_itself = end &&
                             (end->code == worker_wrong_setup || end->code == worker_no_disk) &&
                             !asks_too_much(row);
    add(std::move(trouble), is_outdated   ? words_of_edit(study_.words)
                            : held_itself ? words_of_end(*end, false, study_.words)
                                          : words_of_hold(row, study_.words));
  }

  void look_at_ended(const JobFate& fate, int element, const QueueRow* row) {
    const std::optional<ElementEnd> end = end_of(fate.journal, element, ends_);
    if ((!end && row == nullptr) || !undone_.by(fate.journal, element)) return;
    JobTrouble trouble = trouble_of(fate, element);
    if (row != nullptr) trouble.reason = row->reason;
    const bool is_rest = fate.journal.elements == 0;
    // Slurm knows better than the job's shell why memory or time ran out.
    const bool slurm_knows = row != nullptr && row->state != "FAILED";
    if (was_cancelled(fate, end, row)) {
      trouble.kind = JobTrouble::Kind::cancelled;
      add(std::move(trouble), {"cancelled", ""});
    } else {
      add(std::move(trouble), end && !slurm_knows ? words_of_end(*end, is_rest, study_.words)
                                                  : words_of_state(*row, study_.words));
    }
  }

  static JobTrouble trouble_of(const JobFate& fate, int element) {
    JobTrouble trouble;
    trouble.submission = fate.journal.submission;
    trouble.element = fmt::format("{}.{}", fate.journal.name, element);
    trouble.job = fate.journal.job;
    if (fate.journal.elements > 0) trouble.job += fmt::format("_{}", element);
    return trouble;
  }

  void add(JobTrouble trouble, TroubleWords words) {
    trouble.cause = std::move(words.cause);
    trouble.remedy = std::move(words.remedy);
    troubles_.push_back(std::move(trouble));
  }

  const StudyState& study_;
  Undone undone_;
  std::string ends_of_;
  Ends ends_;
  std::vector<JobTrouble> troubles_;
};

const char* title_of(JobTrouble::Kind kind) {
  constexpr const char* titles[] = {"held by Slurm", "obsolete",
                                    "unresponsive, although running according to Slurm",
                                    "ended abnormally", "cancelled"};
  return titles[static_cast<std::size_t>(kind)];
}

}  // namespace

std::vector<JobTrouble> job_troubles(const std::vector<JobFate>& fates, const StudyState& study) {
  TroubleFinder finder(fates, study);
  for (const JobFate& fate : fates) finder.look_at(fate);
  return std::move(finder).take();
}

std::string troubles_text(const std::vector<JobTrouble>& troubles) {
  std::map<std::pair<JobTrouble::Kind, std::string>, std::vector<const JobTrouble*>> groups;
  for (const JobTrouble& one : troubles) groups[{one.kind, one.cause}].push_back(&one);
  std::string text;
  for (const auto& [kind_and_cause, group] : groups) {
    std::vector<std::string> jobs;
    for (const JobTrouble* one : group) jobs.push_back(one->job);
    text +=
        fmt::format("{}: {} job{} ({})\n  {}\n", title_of(kind_and_cause.first), group.size(),
                    group.size() == 1 ? "" : "s", motion::first_of(jobs, 4), kind_and_cause.second);
    if (!group.front()->remedy.empty()) text += "  " + group.front()->remedy + "\n";
  }
  return text;
}

}  // namespace mien::pipeline
