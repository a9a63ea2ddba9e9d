#include "pipeline/farm/film_pieces.h"

#include <algorithm>
#include <optional>
#include <set>

#include "motion/text/as_number.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/jobs/task_list.h"
#include "pipeline/farm/resumption.h"
#include "pipeline/production/film/film_task.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// `name`: "00012.png"
void mark(const std::string& name, std::vector<bool>& is_there) {
  const auto number = motion::as_number<std::size_t>(name.substr(0, name.find('.')));
  if (number && *number < is_there.size()) is_there[*number] = true;
}

void mark_drawn(const KeptSequence& kept, const fs::path& folder, std::vector<bool>& is_there) {
  const fs::path frames = folder / ".mien" / "partial" / kept.path / kept.key / "frames";
  for (const fs::path& frame : paths_in(frames)) mark(frame.filename().string(), is_there);
}

void mark_published(const KeptSequence& kept, const fs::path& folder, std::vector<bool>& is_there) {
  const std::optional<Receipt> published = read_receipt(folder, kept.path);
  if (!published || published->key != kept.key) return;
  for (const FrameReceipt& frame : published->frames) {
    if (agrees(folder / kept.path / frame.name, frame.hash, frame.size)) mark(frame.name, is_there);
  }
}

/// Outcomes of what a task reads.
std::vector<const TaskOutcome*> inputs_of(const Task& task, const TaskGraph& graph,
                                          const std::vector<TaskOutcome>& planned) {
  std::vector<const TaskOutcome*> inputs;
  for (const std::string& id : task.inputs) inputs.push_back(&planned[graph.index_of(id)]);
  return inputs;
}

/// Calls with each item on the list of a job.
template <class Call>
void each_item(const JobFate& fate, const fs::path& folder, const Call& call) {
  if (fate.journal.elements == 0) return;
  for (const auto& line : lines_of_list(list_of(fate.journal, folder))) {
    for (const std::string& item : line) call(work_item(item));
  }
}

/// Films and in how many chunks they are cut where jobs of them live; 1 of those that one job is to
/// make alone.
std::map<std::string, int> live_cuts(const std::vector<JobFate>& fates,
                                     const std::set<std::string>& covered, const fs::path& folder) {
  std::set<std::string> films;
  for (const std::string& item : covered) films.insert(work_item(item).task);
  std::set<std::string> submissions;
  for (const JobFate& fate : fates) {
    if (fate.kind == JobFate::Kind::live) submissions.insert(fate.journal.submission);
  }
  std::map<std::string, int> cuts;
  for (const JobFate& fate : fates) {
    if (!submissions.contains(fate.journal.submission)) continue;
    each_item(fate, folder, [&](const WorkItem& item) {
      if (!films.contains(item.task)) return;
      int& chunks = cuts[item.task];
      chunks = std::max({chunks, item.chunks, 1});
    });
  }
  return cuts;
}

}  // namespace

PiecesByFilm kept_pieces(const TaskGraph& graph, const std::vector<TaskOutcome>& planned,
                         const std::map<std::string, int>& frames, const fs::path& folder) {
  PiecesByFilm pieces;
  for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
    const Task& task = graph.tasks[i];
    const auto length = frames.find(task.id);
    if (task.kind != "film" || planned[i].state != TaskState::due || length == frames.end())
      continue;
    const KeptSequence kept =
        kept_sequence(task, task_key_of(task, inputs_of(task, graph, planned)));
    std::vector<bool>& is_there = pieces[task.id].is_there;
    is_there.resize(static_cast<std::size_t>(length->second));
    mark_drawn(kept, folder, is_there);
    mark_published(kept, folder, is_there);
  }
  return pieces;
}

void add_live_pieces(const std::vector<JobFate>& fates, const std::map<std::string, int>& frames,
                     const fs::path& folder, PiecesByFilm& pieces) {
  const std::set<std::string> covered = covered_items(fates, folder);
  for (const auto& [film, chunks] : live_cuts(fates, covered, folder)) pieces[film].chunks = chunks;
  for (const std::string& text : covered) {
    const WorkItem item = work_item(text);
    const auto length = frames.find(item.task);
    if (item.chunks == 0 || length == frames.end()) continue;
    std::vector<bool>& is_there = pieces[item.task].is_there;
    is_there.resize(static_cast<std::size_t>(length->second));
    const auto [first, end] = range_of({item.chunk, item.chunks}, length->second);
    std::fill(is_there.begin() + first, is_there.begin() + end, true);
  }
}

}  // namespace mien::pipeline
