#include "pipeline/farm/queue_capacity.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

/// Numbers between colons; nothing for anything else.
std::optional<std::vector<double>> numbers_between_colons(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || number < 0) return std::nullopt;
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    if (text.empty()) return numbers;
    if (!text.starts_with(':')) return std::nullopt;
    text.remove_prefix(1);
  }
}

/// As sbatch reads it: minutes, minutes:seconds, hours:minutes:seconds; behind days and a dash
/// hours, hours:minutes, hours:minutes:seconds.
std::optional<double> seconds_of_limit(std::string_view limit) {
  const std::size_t dash = limit.find('-');
  const bool has_days = dash != std::string_view::npos;
  const auto days = has_days ? numbers_between_colons(limit.substr(0, dash))
                             : std::optional(std::vector<double>{0.0});
  auto parts = numbers_between_colons(has_days ? limit.substr(dash + 1) : limit);
  if (!days || days->size() != 1 || !parts || parts->size() > 3) return std::nullopt;
  if (!has_days && parts->size() < 3) parts->insert(parts->begin(), 0.0);  // there are no hours
  parts->resize(3, 0.0);
  return days->front() * 86400.0 + (*parts)[0] * 3600.0 + (*parts)[1] * 60.0 + (*parts)[2];
}

int most_frames(const Submission& submission) {
  int frames = 1;
  for (const SubmissionStage& stage : submission.stages) {
    for (const SubmissionJob& job : stage.jobs) {
      for (const Element& element : job.elements) frames = std::max(frames, element.frames);
    }
  }
  return frames;
}

/// A number of frames with which it fits, and what becomes of it, in a sentence.
std::string larger_chunk(const std::function<Submission(const Chunking&)>& cut, Chunking chunking,
                         const Submission& submission, const QueueCapacity& capacity) {
  constexpr int most_tries = 20;
  if (chunking.chunk_frames == 0) chunking.chunk_frames = most_frames(submission);
  for (int tries = 0; tries < most_tries; ++tries) {
    chunking.chunk_frames *= 2;
    const int jobs = cut(chunking).jobs();
    if (capacity.has_capacity_for(jobs))
      return fmt::format("--chunk {} gives {} jobs", chunking.chunk_frames, jobs);
  }
  return "";
}

[[noreturn]] void refuse(const Submission& submission, const QueueCapacity& capacity,
                         const std::string& larger) {
  const std::string wait = capacity.used > 0 ? "wait until other jobs have ended" : "";
  std::string remedy = larger.empty() || wait.empty() ? larger + wait : larger + "; or " + wait;
  if (remedy.empty()) remedy = "ask the cluster's administrators for a larger MaxJobCount";
  throw Error(
      fmt::format(
          "the study needs {} jobs, but Slurm has room for {}: it accepts {} jobs of all users "
          "(MaxJobCount) and has {} now, including those that ended in the last minutes",
          submission.jobs(), std::max(0, capacity.limit - 1 - capacity.used), capacity.limit - 1,
          capacity.used),
      remedy);
}

}  // namespace

double longest_element_seconds(const std::string& time_limit) {
  constexpr double hour = 3600.0;
  const auto limit = seconds_of_limit(time_limit);
  return limit && *limit > 0.0 ? std::min(hour, 0.5 * *limit) : hour;
}

FittingSubmission fitting_submission(const std::function<Submission(const Chunking&)>& cut,
                                     const Chunking& requested, double longest_seconds,
                                     const QueueCapacity& capacity) {
  FittingSubmission fitting{cut(requested), requested};
  double& seconds = fitting.chunking.element_seconds;
  while (!capacity.has_capacity_for(fitting.submission.jobs()) && requested.chunk_frames == 0 &&
         seconds < longest_seconds) {
    seconds = std::min(2.0 * seconds, longest_seconds);
    fitting.submission = cut(fitting.chunking);
  }
  if (fitting.submission.elements() == 0 || capacity.has_capacity_for(fitting.submission.jobs()))
    return fitting;
  refuse(fitting.submission, capacity,
         larger_chunk(cut, fitting.chunking, fitting.submission, capacity));
}

}  // namespace mien::pipeline
