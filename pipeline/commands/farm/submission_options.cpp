#include "pipeline/commands/farm/submission_options.h"

#include <algorithm>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "motion/error.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/farm/film_lengths.h"
#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/farm/jobs/worker_reports.h"
#include "pipeline/farm/queue_capacity.h"
#include "pipeline/production/run/run.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

int chunk_frames(const std::string& chunk) {
  if (chunk == "auto") return 0;
  const auto frames = motion::as_number<int>(chunk);
  if (frames && *frames > 0) return *frames;
  throw Error("--chunk: \"" + chunk + "\" is not a number of frames", "write auto, or 1 or more");
}

/// Throws Error unless the value matches a form. `option` and its kind of value: "--mem", "amount
/// of memory".
void require_form(const std::string& value, const char* form, const std::string& option,
                  const std::string& what, const std::string& remedy) {
  if (value.empty() || std::regex_match(value, std::regex(form))) return;
  throw Error(option + ": \"" + value + "\" is not a valid " + what, remedy);
}

Chunking chunking_of(const DueWork& work, const JournalSubmission& requested) {
  Chunking chunking;
  chunking.chunk_frames = requested.chunk_frames;
  chunking.pace = work.pace;
  return chunking;
}

std::vector<Stage> stages_of_due_work(const FarmStudy& study, const DueWork& work,
                                      const Chunking& chunking) {
  return stages_of(study.production.graph(), work.is_due, work.frames, chunking,
                   work.film_progress);
}

void note_longer_elements(const FittingSubmission& fitting, const Chunking& requested,
                          const Console& console) {
  if (fitting.chunking.element_seconds <= requested.element_seconds) return;
  console.err << "note: array elements of up to " << as_duration(fitting.chunking.element_seconds)
              << " instead of " << as_duration(requested.element_seconds)
              << ", because Slurm accepts no more jobs here (MaxJobCount)\n";
}

/// The absolute path of a program. Throws Error if the file cannot be executed.
std::string executable(const std::string& file) {
  const std::filesystem::path path = absolute_path(file);
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown) || ::access(path.c_str(), X_OK) != 0)
    throw Error({"--program"}, motion::in_quotes(file) + " is not a program that can be executed",
                "name the program as the nodes see it, in a folder that this machine sees, too");
  return path.string();
}

std::string element_count_text(int elements) {
  return elements == 0 ? "the rest"
                       : fmt::format("{} element{}", elements, elements == 1 ? "" : "s");
}

double longest(const SubmissionJob& job) {
  double seconds = 0.0;
  for (const Element& element : job.elements) seconds = std::max(seconds, element.seconds);
  return seconds;
}

}  // namespace

std::vector<CommandOption> submission_options(SubmissionOptions& options) {
  return {
      option("--chunk", &options.chunk,
             "Maximum number of frames per array task: auto (about five minutes of work), or a "
             "number"),
      option("--partition", &options.partition, "Slurm partition"),
      option("--time", &options.time, "Time limit per array task: minutes, HH:MM:SS or D-HH:MM:SS"),
      option("--mem", &options.memory, "Memory per array task, such as 2G (default: the site's)"),
      option("--account", &options.account, "Slurm account"),
      option("--array-limit", &options.array_limit, "Maximum number of array tasks running at once")
          .between(1, 1'000'000),
      option("--jobs,-j", &options.jobs,
             "Processors per array task (default: 1; when resuming, as in the last submission)")
          .between(1, 1024),
      option("--program", &options.program,
             "Program that the nodes run instead of this one: mien of the same version in a shared "
             "folder, or a script that starts it in a container")};
}

const JournalSubmission* last_accepted(const JournalContent& journal) {
  const auto was_accepted = [&](const JournalSubmission& submission) {
    return std::none_of(journal.jobs.begin(), journal.jobs.end(), [&](const JournalJob& job) {
      return job.submission == submission.number && job.was_refused;
    });
  };
  const auto found =
      std::find_if(journal.submissions.rbegin(), journal.submissions.rend(), was_accepted);
  return found == journal.submissions.rend() ? nullptr : &*found;
}

JournalSubmission requested_submission(const SubmissionOptions& options,
                                       JournalSubmission earlier) {
  require_form(options.time, R"((\d+|(\d+-)?\d+(:\d+){0,2}))", "--time", "Slurm time limit",
               "write minutes (90), HH:MM:SS (1:30:00) or D-HH:MM:SS (1-12:00:00)");
  require_form(options.memory, R"(\d+[KMGT]?)", "--mem", "amount of memory",
               "write one like 500M or 2G");
  require_form(options.partition, R"([\w.,+-]+)", "--partition", "partition name",
               "sinfo lists the partitions");
  require_form(options.account, R"([\w.,+-]+)", "--account", "account name",
               "write letters and digits");
  const auto take = [](const std::string& given, std::string& to) {
    if (!given.empty()) to = given;
  };
  JobRequest& request = earlier.request;
  take(options.partition, request.partition);
  take(options.time, request.time);
  take(options.memory, request.memory);
  take(options.account, request.account);
  request.array_limit = options.array_limit.value_or(request.array_limit);
  request.processors = options.jobs.value_or(request.processors);
  if (!options.program.empty()) request.program = executable(options.program);
  if (!options.chunk.empty()) earlier.chunk_frames = chunk_frames(options.chunk);
  earlier.when = utc_now();
  return earlier;
}

void refuse_too_many_processors(const JobRequest& request, const Slurm& slurm) {
  const auto most = most_processors(slurm.nodes(), request.partition);
  if (!most || request.processors <= *most) return;
  throw Error(
      fmt::format("--jobs {}: no node of {} has more than {} processor{}", request.processors,
                  request.partition.empty() ? "the default partition" : request.partition, *most,
                  *most == 1 ? "" : "s"),
      "request at most that many, or another --partition; sinfo -N -l lists the nodes");
}

DueWork due_work(FarmStudy& study, const JournalSubmission& requested,
                 const std::vector<JobStatus>& statuses) {
  DueWork work;
  const TaskGraph& graph = study.production.graph();
  const std::vector<TaskOutcome> planned = plan(graph, study.folder);
  for (const TaskOutcome& one : planned) work.is_due.push_back(one.state != TaskState::cached);
  work.is_done = std::find(work.is_due.begin(), work.is_due.end(), true) == work.is_due.end() &&
                 is_recorded(study.production, planned, study.folder);
  work.frames = measured_film_lengths(study.production, study.folder);
  work.film_progress = stored_film_progress(graph, planned, work.frames, study.folder);
  add_frames_of_live_jobs(statuses, work.frames, study.folder, work.film_progress);
  work.pace = measured_pace(worker_reports(study.folder)) / requested.request.processors;
  return work;
}

void remove_old_submissions(const std::vector<JobStatus>& statuses, const DueWork& work,
                            const FarmStudy& study, const Console& console) {
  const TaskGraph& graph = study.production.graph();
  std::set<std::string> due;
  for (std::size_t i = 0; i < graph.tasks.size(); ++i)
    if (work.is_due[i]) due.insert(graph.tasks[i].id);
  const int removed =
      remove_submissions(removable_submissions(statuses, due, study.folder), study.folder);
  if (removed == 0) return;
  console.err << "note: batch files and logs of " << removed << " older submission"
              << (removed == 1 ? "" : "s") << " removed (finished or obsolete)\n";
}

std::vector<Stage> all_stages(FarmStudy& study, const JournalSubmission& requested) {
  DueWork work;
  work.is_due.assign(study.production.graph().tasks.size(), true);
  work.frames = measured_film_lengths(study.production, study.folder);
  work.pace = measured_pace(worker_reports(study.folder)) / requested.request.processors;
  return stages_of_due_work(study, work, chunking_of(work, requested));
}

Submission fitting_submission(const FarmStudy& study, const StudyCall& call, const DueWork& work,
                              const ItemNeeds& needs, const JournalSubmission& requested,
                              const SlurmSite& site, const std::vector<QueueRow>& queue,
                              const Console& console) {
  const std::string key = graph_key(study.production.graph(), study.folder);
  const auto cut = [&](const Chunking& chunking) {
    return submission_of(stages_of_due_work(study, work, chunking), needs, key, requested,
                         study.folder, call, site);
  };
  const Chunking chunking = chunking_of(work, requested);
  FittingSubmission fitting =
      fitting_submission(cut, chunking, longest_element_seconds(requested.request.time),
                         {site.max_job_count, static_cast<int>(queue.size())});
  note_longer_elements(fitting, chunking, console);
  return std::move(fitting.submission);
}

void print_submitted(const Submission& submission, const Submitted& submitted,
                     const FarmArguments& arguments, bool json, const Console& console) {
  if (!submitted.unrecorded.empty())
    console.err
        << "note: " << submitted.unrecorded
        << "; the jobs are submitted nevertheless, and mien farm resume records their numbers\n";
  if (json) {
    ordered_json rows = ordered_json::array();
    for (const SubmittedJob& job : submitted.jobs)
      rows.push_back({{"name", job.name}, {"job", job.job}, {"elements", job.elements}});
    const ordered_json summary = {{"study", submission.call.study},
                                  {"submission", submission.requested.number},
                                  {"folder", submission.folder.string()},
                                  {"elements", submission.elements()},
                                  {"jobs", rows}};
    console.out << summary.dump(2) << '\n';
    return;
  }
  console.out << submission.folder.string() << ":\n";
  for (const SubmittedJob& job : submitted.jobs)
    console.out << fmt::format("  job {:<8} {:<12} {}\n", job.job, job.name,
                               element_count_text(job.elements));
  console.out << "mien farm status " << study_arguments(arguments) << " shows the progress\n";
}

void print_dry_run(const Submission& submission, const Console& console) {
  for (const SubmissionStage& stage : submission.stages) {
    for (const SubmissionJob& job : stage.jobs) {
      console.out << fmt::format("{:<12} {}", job.job.name, element_count_text(job.job.elements));
      if (!job.elements.empty()) {
        const double seconds = longest(job);
        console.out << (seconds < 1.0
                            ? ", less than a second each (estimated)"
                            : fmt::format(", up to {} each (estimated)", as_duration(seconds)));
      }
      console.out << '\n';
    }
  }
  for (const SubmissionStage& stage : submission.stages) {
    for (const SubmissionJob& job : stage.jobs) {
      const std::string stem = (submission.folder / job.job.name).string();
      console.out << "\n==> " << stem << ".sbatch\n" << script_text(submission, job);
      if (!job.elements.empty()) console.out << "\n==> " << stem << ".tasks\n" << list_text(job);
    }
  }
}

}  // namespace mien::pipeline
