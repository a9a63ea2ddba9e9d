#include "pipeline/study/studio/studio_jobs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/film/shot_files.h"
#include "pipeline/production/run/run.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// The manifest with the film of one stimulus alone, in a format for browsers.
Manifest browser_manifest(Manifest manifest, const std::string& id,
                          const std::optional<Quality>& quality) {
  for (Stimulus& stimulus : manifest.stimuli) {
    Output& output = stimulus.output;
    if (stimulus.id != id) continue;
    output.video = {render::VideoKind::mp4};
    output.frames = FrameFormat::none;
    output.clips.clear();
    if (quality) output.quality = *quality;
    for (Person& person : stimulus.people) person.motion.output = output;
  }
  return manifest;
}

/// Progress of a run, by the estimated costs of its tasks.
class RunShare {
 public:
  RunShare(const TaskGraph& graph, std::atomic<double>& share) : share_(share) {
    for (const Task& task : graph.tasks) whole_ += task.cost_seconds;
  }

  RunObserver observer() {
    return {.started = [](const Task&) {},
            .progressed = [this](const Task& task, double share) { tell(task, share); },
            .ended = [this](const Task& task, const TaskOutcome&) { tell(task, 1.0); }};
  }

 private:
  void tell(const Task& task, double share) {
    done_[task.id] = share * task.cost_seconds;
    double sum = 0.0;
    for (const auto& [id, seconds] : done_) sum += seconds;
    share_ = whole_ > 0.0 ? std::min(1.0, sum / whole_) : 0.0;
  }

  std::atomic<double>& share_;
  double whole_ = 0.0;
  std::map<std::string, double> done_;
};

std::string first_error(const RunResult& result) {
  for (const TaskOutcome& outcome : result.outcomes)
    if (!outcome.error.empty()) return outcome.error;
  return "rendering failed";
}

}  // namespace

std::optional<int> StudioJobs::begin(StudioJob job) {
  std::jthread ended;  // joined after the mutex is released
  const std::lock_guard lock(mutex_);
  if (state_ == "running") return std::nullopt;
  ended = std::move(thread_);
  kind_ = job.kind == StudioJob::Kind::still ? "still" : "video";
  stimulus_ = job.stimulus;
  state_ = "running";
  message_.clear();
  result_.clear();
  share_ = 0.0;
  thread_ =
      std::jthread([this, job = std::move(job)](const std::stop_token& stop) { work(job, stop); });
  return ++number_;
}

nlohmann::ordered_json StudioJobs::status(int job) const {
  nlohmann::ordered_json status = last();
  if (!status.is_null() && status["job"] != job) return nullptr;
  return status;
}

nlohmann::ordered_json StudioJobs::last() const {
  const std::lock_guard lock(mutex_);
  if (number_ == 0) return nullptr;
  return {{"job", number_},  {"kind", kind_},          {"stimulus", stimulus_},
          {"state", state_}, {"share", share_.load()}, {"told", message_}};
}

void StudioJobs::cancel() {
  const std::lock_guard lock(mutex_);
  thread_.request_stop();
}

std::optional<fs::path> StudioJobs::result(int job) const {
  const std::lock_guard lock(mutex_);
  if (job != number_ || state_ != "done") return std::nullopt;
  return result_;
}

void StudioJobs::end(const std::string& state, const std::string& status) {
  const std::lock_guard lock(mutex_);
  state_ = state;
  message_ = status;
}

void StudioJobs::work(const StudioJob& job, const std::stop_token& stop) {
  try {
    fs::path made =
        job.kind == StudioJob::Kind::still ? make_still(job, stop) : make_video(job, stop);
    const std::string place = made.string();
    {
      const std::lock_guard lock(mutex_);
      result_ = std::move(made);
    }
    end("done", place);
  } catch (const Interrupted&) {
    end("cancelled", "");
  } catch (const std::exception& error) {
    end(stop.stop_requested() ? "cancelled" : "failed", error.what());
  }
}

fs::path StudioJobs::make_still(const StudioJob& job, const std::stop_token& stop) {
  const Manifest manifest = browser_manifest(job.manifest, job.stimulus, job.quality);
  Motions motions(manifest);
  const Stimulus& stimulus = *find_stimulus(manifest, job.stimulus);
  const scenes::Shot shot = shot_of(stimulus, motions, manifest.seed);
  const FilmSettings settings{
      .output = stimulus.output, .seed = manifest.seed, .threads = threads_};
  const double requested_frame = std::max(0.0, job.seconds) * stimulus.output.fps;
  const int last = shot.frame_count() - 1;
  const int frame = requested_frame < last ? static_cast<int>(std::lround(requested_frame)) : last;
  if (stop.stop_requested()) throw Interrupted{};
  make_folder(folder_ / "stills");
  ResultFile still(folder_ / "stills" / fmt::format("{}-{:05}.png", job.stimulus, frame));
  write_still({shot, settings, stop, [this](double share) { share_ = share; }}, frame,
              render::Background::shown, still.draft());
  if (stop.stop_requested()) throw Interrupted{};
  still.publish();
  return still.target();
}

fs::path StudioJobs::make_video(const StudioJob& job, const std::stop_token& stop) {
  Production production(browser_manifest(job.manifest, job.stimulus, job.quality),
                        {.only = {job.stimulus}, .jobs = threads_});
  RunShare share(production.graph(), share_);
  const RunResult result = run(production, folder_, threads_, stop, share.observer());
  if (result.was_interrupted) throw Interrupted{};
  if (!result.is_complete()) throw std::runtime_error(first_error(result));
  return folder_ / "videos" / (job.stimulus + ".mp4");
}

}  // namespace mien::pipeline
