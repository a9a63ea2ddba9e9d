#include "pipeline/farm/jobs/submission_journal.h"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "motion/text/result_file.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

JobRequest request_in(const ordered_json& entry) {
  return {.partition = entry.value("partition", ""),
          .time = entry.value("time", ""),
          .memory = entry.value("mem", ""),
          .account = entry.value("account", ""),
          .array_limit = entry.value("array_limit", 0),
          .processors = entry.value("jobs", 1),
          .program = entry.value("program", "")};
}

/// The last job with that comment; comments are unique within a study.
JournalJob* job_called(JournalContent& content, const std::string& comment) {
  const auto found = std::find_if(content.jobs.rbegin(), content.jobs.rend(),
                                  [&](const JournalJob& job) { return job.comment == comment; });
  return found == content.jobs.rend() ? nullptr : &*found;
}

/// A member that names a folder or file of the farm. Throws Error if it is not a plain name.
std::string checked_component(const ordered_json& entry, const char* member) {
  return motion::safe_component(entry.at(member).get<std::string>(), {});
}

std::string line_of(const JournalSubmission& submission) {
  const JobRequest& request = submission.request;
  return ordered_json{{"event", "submission"},
                      {"submission", submission.number},
                      {"when", submission.when},
                      {"quality", submission.quality},
                      {"chunk", submission.chunk_frames},
                      {"partition", request.partition},
                      {"time", request.time},
                      {"mem", request.memory},
                      {"account", request.account},
                      {"array_limit", request.array_limit},
                      {"jobs", request.processors},
                      {"program", request.program}}
      .dump();
}

std::string line_of(const JournalJob& intent) {
  return ordered_json{{"event", "intent"},           {"submission", intent.submission},
                      {"name", intent.name},         {"comment", intent.comment},
                      {"elements", intent.elements}, {"mem", intent.memory},
                      {"when", intent.when}}
      .dump();
}

void apply_entry(const ordered_json& entry, JournalContent& content) {
  const std::string event = entry.at("event");
  if (event == "submission") {
    content.submissions.push_back({checked_component(entry, "submission"), entry.value("when", ""),
                                   entry.value("quality", ""), entry.value("chunk", 0),
                                   request_in(entry)});
    return;
  }
  const std::string comment = entry.at("comment");
  if (event == "intent") {
    content.jobs.push_back({.submission = checked_component(entry, "submission"),
                            .name = checked_component(entry, "name"),
                            .comment = comment,
                            .elements = entry.at("elements"),
                            .memory = entry.value("mem", ""),
                            .when = entry.value("when", "")});
  } else if (JournalJob* job = job_called(content, comment)) {
    if (event == "submitted") job->job = entry.at("job");
    if (event == "refused") job->was_refused = true;
    if (event == "cancelled") job->was_cancelled = true;
  }
}

}  // namespace

std::string utc_now() { return fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr))); }

SubmissionJournal::SubmissionJournal(const fs::path& folder)
    : file_(folder / "farm" / "journal.jsonl") {}

JournalContent SubmissionJournal::read() const {
  JournalContent content;
  std::error_code error;
  if (!fs::is_regular_file(file_, error)) return content;
  std::istringstream lines(read_file(file_));
  for (std::string line; std::getline(lines, line);) {
    try {
      apply_entry(ordered_json::parse(line), content);
    } catch (const std::exception&) {  // of the JSON, or Error
      continue;
    }
  }
  return content;
}

void SubmissionJournal::note_submission(const JournalSubmission& submission,
                                        const std::vector<JournalJob>& intents) const {
  std::string lines = line_of(submission);
  for (const JournalJob& intent : intents) lines += "\n" + line_of(intent);
  append(lines);
}

void SubmissionJournal::note_job(const std::string& comment, const std::string& job) const {
  append(ordered_json{{"event", "submitted"}, {"comment", comment}, {"job", job}}.dump());
}

void SubmissionJournal::note_refusal(const std::string& comment, const std::string& why) const {
  append(ordered_json{{"event", "refused"}, {"comment", comment}, {"why", why}}.dump(
      -1, ' ', false, ordered_json::error_handler_t::replace));
}

void SubmissionJournal::note_cancel(const std::string& comment, const std::string& job) const {
  append(ordered_json{{"event", "cancelled"}, {"comment", comment}, {"job", job}}.dump());
}

/// Starts with a line break if a crash truncated the last line. A single write, so that lines of
/// two processes do not mix.
void SubmissionJournal::append(const std::string& lines) const {
  make_folder(file_.parent_path());
  const int file = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const auto refuse = [&](int why) {
    if (file >= 0) ::close(file);
    throw cannot_be_written(file_, {why, std::generic_category()});
  };
  if (file < 0) refuse(errno);
  char last = '\n';
  const off_t size = ::lseek(file, 0, SEEK_END);
  if (size > 0 && ::pread(file, &last, 1, size - 1) != 1) refuse(errno);
  const std::string bytes = (last == '\n' ? "" : "\n") + lines + "\n";
  const ssize_t count = ::write(file, bytes.data(), bytes.size());
  if (count != static_cast<ssize_t>(bytes.size())) refuse(count < 0 ? errno : ENOSPC);
  if (::fsync(file) != 0) refuse(errno);
  ::close(file);
  flush_to_disk(file_.parent_path());
}

}  // namespace mien::pipeline
