#include <algorithm>
#include <iterator>
#include <memory>
#include <set>

#include "motion/error.h"
#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/farm_status.h"
#include "pipeline/farm/jobs/element_logs.h"
#include "pipeline/farm/slurm/slurm.h"
#include "pipeline/farm/worker.h"

namespace mien::pipeline {

namespace {

struct LogsCommand {
  FarmArguments study;
  std::string item;
  int lines = 20;
};

/// Prints logs, each file once.
class LogList {
 public:
  void add(const std::vector<ElementLog>& more) {
    for (const ElementLog& log : more)
      if (seen_.insert(log.file).second) logs_.push_back(log);
  }

  void show(int lines, const Console& console) const {
    for (const ElementLog& log : logs_)
      console.out << "==> " << log.item << ": " << log.file.string() << '\n'
                  << last_lines(log.file, lines);
  }

  bool empty() const { return logs_.empty(); }

 private:
  std::vector<ElementLog> logs_;
  std::set<std::filesystem::path> seen_;
};

/// Problems according to the records of jobs and, if Slurm is available, squeue.
std::vector<JobProblem> problems_of(const FarmStudy& study, const StudyState& state) {
  const JournalContent journal = SubmissionJournal(study.folder).read();
  if (journal.jobs.empty()) return {};
  std::string why;
  const auto queue = Slurm().queue_if_any(why).value_or(std::vector<QueueRow>());
  return job_problems(job_statuses(journal, queue, study.folder), state);
}

/// Shows the logs of failures: those recorded by workers, and those of failed or held jobs of all
/// submissions.
void show_failures(const FarmStudy& study, const LogsCommand& command, const Console& console) {
  const StudyState state =
      study_state(study.production, study.folder, study_arguments(command.study));
  std::vector<JobProblem> problems = problems_of(study, state);
  const auto cancelled = std::stable_partition(
      problems.begin(), problems.end(),
      [](const JobProblem& problem) { return problem.kind != JobProblem::Kind::cancelled; });
  const auto cancelled_count = std::distance(cancelled, problems.end());
  problems.erase(cancelled, problems.end());
  LogList logs;
  for (const FailedItem& failed : present_failures(study.production.graph(), state))
    logs.add(find_logs(failed.item, study.folder));
  logs.add(find_logs(problems, study.folder));
  logs.show(command.lines, console);
  std::erase_if(problems, [&](const JobProblem& problem) {
    return !find_logs(std::vector<JobProblem>{problem}, study.folder).empty();
  });
  if (!problems.empty()) console.out << "without a log:\n" << problems_text(problems);
  if (logs.empty() && problems.empty())
    console.out << study.folder.string() << ": no logs of failed jobs\n";
  if (cancelled_count > 0)
    console.out << "cancelled jobs are not shown: " << cancelled_count << "; mien farm logs "
                << study_arguments(command.study) << " ITEM shows the log of one item\n";
}

void show_item(const FarmStudy& study, const LogsCommand& command, const Console& console) {
  LogList logs;
  logs.add(find_logs(command.item, study.folder));
  if (logs.empty()) {
    (void)graph_of_items(study.production.graph(), {command.item});  // says what was meant
    throw Error("no job for " + command.item + " has written a log",
                "mien farm status shows what is waiting");
  }
  logs.show(command.lines, console);
}

int show_logs(const LogsCommand& command, const Console& console) {
  const FarmStudy study(command.study, console);
  if (command.item.empty()) {
    show_failures(study, command, console);
  } else {
    show_item(study, command, console);
  }
  return exit_done;
}

}  // namespace

Command farm_logs_command() {
  const auto options = std::make_shared<LogsCommand>();
  return {
      .name = "logs",
      .summary = "Show the last log lines of failed jobs",
      .options = all_of(farm_options(options->study),
                        argument("task", &options->item,
                                 "Show the log of this task instead: film:walk, or film:walk[3/12]")
                            .optional(),
                        option("--lines,-n", &options->lines, "Number of lines per log")
                            .between(1, 10000)
                            .with_default()),
      .notes = "Examples:\n  mien farm logs my.yaml\n  mien farm logs my.yaml film:target-1",
      .run = [options](const Console& console) { return show_logs(*options, console); }};
}

}  // namespace mien::pipeline
