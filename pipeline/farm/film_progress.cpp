#include "pipeline/farm/film_progress.h"

#include <algorithm>
#include <optional>
#include <set>

#include "motion/text/as_number.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/jobs/task_list.h"
#include "pipeline/farm/resumption.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// `name`: "00012.png"
void mark(const std::string& name, std::vector<bool>& has_frame) {
  const auto number = motion::as_number<std::size_t>(name.substr(0, name.find('.')));
  if (number && *number < has_frame.size()) has_frame[*number] = true;
}

void mark_drawn(const StoredSequence& kept, const fs::path& folder, std::vector<bool>& has_frame) {
  const fs::path frames = folder / ".mien" / "partial" / kept.path / kept.key / "frames";
  for (const fs::path& frame : paths_in(frames)) mark(frame.filename().string(), has_frame);
}

void mark_published(const StoredSequence& kept, const fs::path& folder,
                    std::vector<bool>& has_frame) {
  const std::optional<Receipt> published = read_receipt(folder, kept.path);
  if (!published || published->key != kept.key) return;
  for (const FrameReceipt& frame : published->frames) {
    if (agrees(folder / kept.path / frame.name, frame.hash, frame.size))
      mark(frame.name, has_frame);
  }
}

/// Calls with each item on the list of a job.
template <class Call>
void each_item(const JobStatus& job_status, const fs::path& folder, const Call& call) {
  if (job_status.journal.elements == 0) return;
  for (const auto& line : lines_of_list(list_of(job_status.journal, folder))) {
    for (const std::string& item : line) call(work_item(item));
  }
}

/// Films and in how many chunks they are cut where jobs of them live; 1 of those that one job is to
/// make alone.
std::map<std::string, int> chunks_of_live_jobs(const std::vector<JobStatus>& statuses,
                                               const std::set<std::string>& covered,
                                               const fs::path& folder) {
  std::set<std::string> films;
  for (const std::string& item : covered) films.insert(work_item(item).task);
  std::set<std::string> submissions;
  for (const JobStatus& job_status : statuses) {
    if (job_status.kind == JobStatus::Kind::live) submissions.insert(job_status.journal.submission);
  }
  std::map<std::string, int> cuts;
  for (const JobStatus& job_status : statuses) {
    if (!submissions.contains(job_status.journal.submission)) continue;
    each_item(job_status, folder, [&](const WorkItem& item) {
      if (!films.contains(item.task)) return;
      int& chunks = cuts[item.task];
      chunks = std::max({chunks, item.chunks, 1});
    });
  }
  return cuts;
}

}  // namespace

StoredSequence stored_sequence(const Task& film, const TaskGraph& graph,
                               const std::vector<TaskOutcome>& planned) {
  std::vector<const TaskOutcome*> inputs;
  for (const std::string& id : film.inputs) inputs.push_back(&planned[graph.index_of(id)]);
  return stored_sequence(film, task_key_of(film, inputs));
}

ProgressByFilm stored_film_progress(const TaskGraph& graph, const std::vector<TaskOutcome>& planned,
                                    const std::map<std::string, int>& frames,
                                    const fs::path& folder) {
  ProgressByFilm film_progress;
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    const Task& task = graph.tasks[i];
    const auto length = frames.find(task.id);
    if (task.kind != "film" || planned[i].state != TaskState::due || length == frames.end())
      continue;
    const StoredSequence kept = stored_sequence(task, graph, planned);
    std::vector<bool>& has_frame = film_progress[task.id].has_frame;
    has_frame.resize(static_cast<std::size_t>(length->second));
    mark_drawn(kept, folder, has_frame);
    mark_published(kept, folder, has_frame);
  }
  return film_progress;
}

void add_frames_of_live_jobs(const std::vector<JobStatus>& statuses,
                             const std::map<std::string, int>& frames, const fs::path& folder,
                             ProgressByFilm& film_progress) {
  const std::set<std::string> covered = covered_items(statuses, folder);
  for (const auto& [film, chunks] : chunks_of_live_jobs(statuses, covered, folder))
    film_progress[film].chunks = chunks;
  for (const std::string& text : covered) {
    const WorkItem item = work_item(text);
    const auto length = frames.find(item.task);
    if (item.chunks == 0 || length == frames.end()) continue;
    std::vector<bool>& has_frame = film_progress[item.task].has_frame;
    has_frame.resize(static_cast<std::size_t>(length->second));
    const auto [first, end] = range_of({item.chunk, item.chunks}, length->second);
    std::fill(has_frame.begin() + first, has_frame.begin() + end, true);
  }
}

}  // namespace mien::pipeline
