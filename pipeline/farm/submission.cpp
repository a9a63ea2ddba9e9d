#include "pipeline/farm/submission.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/farm/memory_amount.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

int place_of(const std::string& stage) {
  constexpr std::array names = {"motions", "frames", "films", "sheets", "study"};
  return static_cast<int>(std::find(names.begin(), names.end(), stage) - names.begin()) + 1;
}

constexpr int films_place = 3;
constexpr int rest_place = 6;

/// Without the items that live jobs make.
Stage without(Stage stage, const std::set<std::string>& covered) {
  for (Element& element : stage.elements) {
    std::erase_if(element.items, [&](const std::string& item) { return covered.contains(item); });
  }
  std::erase_if(stage.elements, [](const Element& element) { return element.items.empty(); });
  return stage;
}

/// Amount of memory to request for an element of which items ran out of it; empty if none did.
std::string memory_of(const Element& element, const ItemNeeds& needs) {
  std::string largest;
  for (const std::string& item : element.items) {
    const auto found = needs.memory.find(work_item(item).task);
    if (found != needs.memory.end()) largest = larger_memory(largest, found->second);
  }
  return largest;
}

/// Amount of memory to request for the final job, which makes whatever is missing.
std::string memory_of_rest(const ItemNeeds& needs, const std::string& requested) {
  std::string largest = larger_memory(requested, needs.rest_memory);
  for (const auto& [task, memory] : needs.memory) largest = larger_memory(largest, memory);
  return largest;
}

std::string comment_of(const std::string& key, const std::string& number, const std::string& name) {
  return "mien:" + key + ":" + number + ":" + name;
}

/// Elements of a stage in arrays: those of one memory together, and no more than fit.
class Arrays {
 public:
  Arrays(std::string name, const std::string& key, const JournalSubmission& requested,
         std::size_t most)
      : name_(std::move(name)), key_(key), requested_(requested), most_(most) {}

  void add(const Element& element, const std::string& memory) {
    const std::string requested = larger_memory(requested_.request.memory, memory);
    auto open = std::find_if(jobs_.begin(), jobs_.end(), [&](const SubmissionJob& job) {
      return job.request.memory == requested && job.elements.size() < most_;
    });
    if (open == jobs_.end()) open = jobs_.insert(jobs_.end(), new_job(requested));
    open->elements.push_back(element);
    open->job.elements = static_cast<int>(open->elements.size());
  }

  std::vector<SubmissionJob> done() && { return std::move(jobs_); }

 private:
  SubmissionJob new_job(const std::string& memory) const {
    SubmissionJob job;
    job.job.submission = requested_.number;
    job.job.name = jobs_.empty() ? name_ : fmt::format("{}-{}", name_, jobs_.size() + 1);
    job.job.comment = comment_of(key_, requested_.number, job.job.name);
    job.request = requested_.request;
    job.request.memory = memory;
    return job;
  }

  std::string name_;
  const std::string& key_;
  const JournalSubmission& requested_;
  std::size_t most_;
  std::vector<SubmissionJob> jobs_;
};

SubmissionJob rest_job(const std::string& key, const JournalSubmission& requested,
                       const ItemNeeds& needs) {
  SubmissionJob rest;
  rest.job.submission = requested.number;
  rest.job.name = fmt::format("{}-rest", rest_place);
  rest.job.comment = comment_of(key, requested.number, rest.job.name);
  rest.request = requested.request;
  rest.request.memory = memory_of_rest(needs, requested.request.memory);
  return rest;
}

/// The number of a job that Slurm accepted without answering, found by its comment. Empty if Slurm
/// has no such job or does not answer.
std::string job_after_timeout(const Slurm& slurm, const BatchJob& job) {
  std::string why;
  const auto queue = slurm.queue_if_any(why);
  if (!queue) return "";
  for (const QueueRow& row : *queue) {
    if (row.comment == job.comment && is_live(row)) return row.array;
  }
  return "";
}

std::string submitted(const fs::path& script, const BatchJob& job, const Slurm& slurm,
                      const std::vector<std::string>& after) {
  try {
    return slurm.submit(script, after);
  } catch (const SlurmTimeout&) {
    const std::string found = job_after_timeout(slurm, job);
    if (found.empty()) throw;
    return found;
  } catch (const SlurmQueueFull&) {  // the last of its tries may have been taken
    const std::string found = job_after_timeout(slurm, job);
    if (found.empty()) throw;
    return found;
  }
}

JournalJob intent_of(const SubmissionJob& job) {
  return {.submission = job.job.submission,
          .name = job.job.name,
          .comment = job.job.comment,
          .elements = job.job.elements,
          .memory = job.request.memory,
          .when = utc_now()};
}

std::vector<std::string> numbers_of(const std::vector<SubmittedJob>& jobs) {
  std::vector<std::string> numbers;
  for (const SubmittedJob& job : jobs) numbers.push_back(job.job);
  return numbers;
}

/// Removes what was written for a submission of which no job has begun.
void remove_unused(const fs::path& folder) {
  std::error_code error;
  if (fs::is_empty(folder / "log", error) && fs::is_empty(folder / "ends", error))
    fs::remove_all(folder, error);
}

std::vector<JournalJob> intents_of(const Submission& submission) {
  std::vector<JournalJob> intents;
  for (const SubmissionStage& stage : submission.stages) {
    for (const SubmissionJob& job : stage.jobs) intents.push_back(intent_of(job));
  }
  return intents;
}

/// Cancels the jobs accepted before one was refused. Returns a sentence about the outcome.
std::string undo(const Submission& submission, const std::vector<SubmittedJob>& done,
                 const Slurm& slurm, const SubmissionJournal& journal, const std::string& why) {
  const std::vector<std::string> taken = numbers_of(done);
  try {
    slurm.cancel(taken);
  } catch (const std::exception& fault) {
    return fmt::format("\nthe jobs accepted before could not be cancelled (scancel {}): {}",
                       fmt::join(taken, " "), fault.what());
  }
  withdraw(submission, journal, why);
  return done.empty() ? "" : "\nthe jobs accepted before were cancelled";
}

/// If the journal is not writable any more, the job is still identified by its comment.
void note_number(const SubmissionJournal& journal, const BatchJob& job, const std::string& number,
                 std::string& unrecorded) {
  try {
    journal.note_job(job.comment, number);
  } catch (const std::exception& fault) {
    unrecorded = fault.what();
  }
}

/// Adds it to `done` and gives its number.
std::string submit_one(const Submission& submission, const SubmissionJob& one,
                       const std::vector<std::string>& before, const Slurm& slurm,
                       const SubmissionJournal& journal, Submitted& done) {
  const fs::path script = submission.folder / (one.job.name + ".sbatch");
  try {
    done.jobs.push_back(
        {one.job.name, submitted(script, one.job, slurm, before), one.job.elements});
  } catch (const SlurmTimeout& timeout) {
    throw SlurmTimeout(timeout.what() +
                       std::string("\nthe jobs accepted so far remain: mien farm status shows "
                                   "them, mien farm resume submits the rest"));
  } catch (const std::exception& fault) {
    throw SlurmFault(fault.what() + undo(submission, done.jobs, slurm, journal, fault.what()));
  }
  note_number(journal, one.job, done.jobs.back().job, done.unrecorded);
  return done.jobs.back().job;
}

void write_files(const Submission& submission,
                 const std::vector<std::pair<fs::path, std::string>>& files) {
  make_folder(submission.folder / "log");
  make_folder(submission.folder / "ends");
  for (const auto& [file, text] : files) write_file(file, text);
}

}  // namespace

std::string next_submission(const fs::path& study_folder) {
  std::set<std::string> taken;  // one that was refused has no folder, but jobs of its name
  for (const JournalSubmission& one : SubmissionJournal(study_folder).read().submissions)
    taken.insert(one.number);
  int number = 1;
  const auto name = [&] { return fmt::format("{:04}", number); };
  while (taken.contains(name()) || fs::exists(study_folder / "farm" / name())) ++number;
  return name();
}

std::string graph_key(const TaskGraph& graph, const fs::path& study_folder) {
  return KeyBuilder()
      .add("folder", study_folder.string())
      .add("graph", key_of(graph))
      .key()
      .substr(0, 12);
}

Submission submission_of(const std::vector<Stage>& stages, const ItemNeeds& needs,
                         const std::string& graph_key, JournalSubmission requested,
                         const fs::path& study_folder, const StudyCall& call,
                         const SlurmSite& site) {
  Submission submission;
  submission.requested = std::move(requested);
  submission.folder = study_folder / "farm" / submission.requested.number;
  submission.call = call;
  submission.site = site;
  // Lines are counted from 1, and an index is below the limit.
  const auto most = static_cast<std::size_t>(std::max(1, site.max_array_size - 1));
  for (const Stage& whole : stages) {
    const Stage stage = without(whole, needs.covered);
    const std::string name = fmt::format("{}-{}", place_of(stage.name), stage.name);
    Arrays arrays(name, graph_key, submission.requested, most);
    for (const Element& element : stage.elements) arrays.add(element, memory_of(element, needs));
    if (auto jobs = std::move(arrays).done(); !jobs.empty()) {
      submission.stages.push_back({place_of(stage.name), std::move(jobs)});
    }
  }
  submission.stages.push_back({rest_place, {rest_job(graph_key, submission.requested, needs)}});
  return submission;
}

std::string script_text(const Submission& submission, const SubmissionJob& job) {
  return batch_script(job.job, submission.folder, submission.call, job.request, submission.site);
}

std::string list_text(const SubmissionJob& job) {
  std::string text;
  for (const Element& element : job.elements)
    text += fmt::format("{}\n", fmt::join(element.items, " "));
  return text;
}

void write_submission(const Submission& submission, const SubmissionJournal& journal) {
  // All texts first: what is wrong with a path leaves no folder behind.
  std::vector<std::pair<fs::path, std::string>> files;
  for (const SubmissionStage& stage : submission.stages) {
    for (const SubmissionJob& job : stage.jobs) {
      const fs::path stem = submission.folder / job.job.name;
      files.emplace_back(stem.string() + ".sbatch", script_text(submission, job));
      if (!job.elements.empty()) files.emplace_back(stem.string() + ".tasks", list_text(job));
    }
  }
  make_folder(submission.folder.parent_path());
  if (!fs::create_directory(submission.folder)) {
    throw std::runtime_error(submission.folder.string() +
                             " was just created by another submission; see mien farm status");
  }
  try {
    write_files(submission, files);
    journal.note_submission(submission.requested, intents_of(submission));
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(submission.folder, ignored);
    throw;
  }
}

void withdraw(const Submission& submission, const SubmissionJournal& journal,
              const std::string& why) {
  try {
    for (const JournalJob& intent : intents_of(submission))
      journal.note_refusal(intent.comment, why);
  } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): the disk is full; the caller
  }                                  // reports the reason, and Slurm has no such jobs
  remove_unused(submission.folder);
}

int Submission::elements() const {
  int count = 0;
  for (const SubmissionStage& stage : stages) {
    for (const SubmissionJob& job : stage.jobs) count += job.job.elements;
  }
  return count;
}

Submitted submit(const Submission& submission, const Slurm& slurm, const SubmissionJournal& journal,
                 const std::vector<std::string>& live) {
  Submitted done;
  std::vector<std::string> last_stage;
  for (const SubmissionStage& stage : submission.stages) {
    std::vector<std::string> before = last_stage;
    if (stage.place == rest_place) before = numbers_of(done.jobs);
    if (stage.place >= films_place) before.insert(before.end(), live.begin(), live.end());
    last_stage.clear();
    for (const SubmissionJob& one : stage.jobs) {
      last_stage.push_back(submit_one(submission, one, before, slurm, journal, done));
    }
  }
  return done;
}

}  // namespace mien::pipeline
