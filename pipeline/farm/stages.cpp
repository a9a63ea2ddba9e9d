#include "pipeline/farm/stages.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mien::pipeline {

namespace {

// Proportion of a film's cost that remains when its frames exist: encoding.
constexpr double encoding_share = 0.1;

/// Fills one element after the other; a new one is begun where the next item does not fit.
class Packer {
 public:
  Packer(std::string name, const Chunking& chunking) : chunking_(chunking) {
    stage_.name = std::move(name);
  }

  void add(const std::string& item, double seconds, int frames) {
    if (stage_.elements.empty() || !fits(stage_.elements.back(), seconds, frames)) begin();
    Element& element = stage_.elements.back();
    element.items.push_back(item);
    element.seconds += seconds;
    element.frames += frames;
  }

  /// The next item begins an element of its own.
  void begin() { stage_.elements.emplace_back(); }

  Stage done() && { return std::move(stage_); }

 private:
  bool fits(const Element& element, double seconds, int frames) const {
    if (element.items.empty()) return true;
    if (chunking_.chunk_frames > 0 && frames > 0) {
      return element.frames == 0 || element.frames + frames <= chunking_.chunk_frames;
    }
    return element.seconds + seconds <= chunking_.element_seconds;
  }

  const Chunking& chunking_;
  Stage stage_;
};

struct Due {
  const TaskGraph& graph;
  const std::vector<bool>& is_due;
  const std::map<std::string, int>& frames;
  const Chunking& chunking;
  const std::map<std::string, FilmProgress>& film_progress;

  int frames_of(const Task& task) const {
    const auto found = frames.find(task.id);
    return found == frames.end() ? 0 : std::max(found->second, 1);
  }

  double seconds_of(const Task& task) const { return task.cost_seconds * chunking.pace; }

  /// For the frames from `first` to before `end`.
  int missing_of(const Task& task, int first, int end) const {
    const auto found = film_progress.find(task.id);
    if (found == film_progress.end()) return end - first;
    const std::vector<bool>& has_frame = found->second.has_frame;
    int missing = 0;
    for (int frame = first; frame < end; ++frame) {
      const auto at = static_cast<std::size_t>(frame);
      missing += at < has_frame.size() && has_frame[at] ? 0 : 1;
    }
    return missing;
  }

  double seconds_of_drawing(const Task& task, int frame_count) const {
    const double whole = seconds_of(task) * (1.0 - encoding_share);
    return frame_count == 0 ? 0.0 : whole * frame_count / frames_of(task);
  }

  int chunks_of(const Task& task) const {
    const int count = frames_of(task);
    if (count == 0) return 1;
    const auto begun = film_progress.find(task.id);
    if (begun != film_progress.end() && begun->second.chunks > 0) return begun->second.chunks;
    int in_one = chunking.chunk_frames;
    if (in_one == 0) {
      const double frame = seconds_of(task) / count;
      in_one = frame * count <= chunking.element_seconds
                   ? count
                   : std::max(1, static_cast<int>(chunking.element_seconds / frame));
    }
    return (count + in_one - 1) / in_one;
  }

  template <class Call>
  void each(const std::string& stage, const Call& call) const {
    for (std::size_t i = 0; i < graph.tasks.size(); ++i) {
      if (is_due[i] && stage_of(graph.tasks[i]) == stage) call(graph.tasks[i]);
    }
  }
};

Stage grouped(const Due& due, const std::string& name) {
  Packer packer(name, due.chunking);
  due.each(name, [&](const Task& task) { packer.add(task.id, due.seconds_of(task), 0); });
  return std::move(packer).done();
}

/// Motions first; what is found of all of them together begins after them.
Stage motions_stage(const Due& due) {
  Packer packer("motions", due.chunking);
  bool are_motions = true;
  due.each("motions", [&](const Task& task) {
    if (are_motions && task.kind != "motion") packer.begin();
    are_motions = task.kind == "motion";
    packer.add(task.id, due.seconds_of(task), 0);
  });
  Stage stage = std::move(packer).done();
  std::erase_if(stage.elements, [](const Element& element) { return element.items.empty(); });
  return stage;
}

Stage frames_stage(const Due& due) {
  Packer packer("frames", due.chunking);
  due.each("films", [&](const Task& task) {
    const int chunks = due.chunks_of(task);
    if (chunks == 1) return;
    for (int chunk = 1; chunk <= chunks; ++chunk) {
      const auto [first, end] = range_of({chunk, chunks}, due.frames_of(task));
      const int missing = due.missing_of(task, first, end);
      if (missing == 0) continue;
      packer.add(chunk_item(task.id, chunk, chunks), due.seconds_of_drawing(task, missing),
                 missing);
    }
  });
  return std::move(packer).done();
}

Stage films_stage(const Due& due) {
  Packer packer("films", due.chunking);
  due.each("films", [&](const Task& task) {
    const int frames = due.frames_of(task);
    const double drawing = frames == 0 ? due.seconds_of(task) * (1.0 - encoding_share)
                           : due.chunks_of(task) > 1
                               ? 0.0
                               : due.seconds_of_drawing(task, due.missing_of(task, 0, frames));
    packer.add(task.id, due.seconds_of(task) * encoding_share + drawing, frames);
  });
  return std::move(packer).done();
}

/// One element: each task of it needs the one before.
Stage study_stage(const Due& due) {
  Stage stage{"study", {}};
  due.each("study", [&](const Task& task) {
    if (stage.elements.empty()) stage.elements.emplace_back();
    stage.elements.back().items.push_back(task.id);
    stage.elements.back().seconds += due.seconds_of(task);
  });
  return stage;
}

}  // namespace

double Stage::seconds() const {
  double sum = 0.0;
  for (const Element& element : elements) sum += element.seconds;
  return sum;
}

std::string stage_of(const Task& task) {
  if (task.kind == "film" || task.kind == "clip" || task.kind == "dots") return "films";
  if (task.kind == "sheet") return "sheets";
  constexpr std::array equalizing = {"sizes", "places", "exposure"};
  const bool equalizes = std::any_of(equalizing.begin(), equalizing.end(), [&](const char* id) {
    return task.id == id || task.kind == id;
  });
  return task.kind == "motion" || equalizes ? "motions" : "study";
}

std::vector<Stage> stages_of(const TaskGraph& graph, const std::vector<bool>& is_due,
                             const std::map<std::string, int>& frames, const Chunking& chunking,
                             const std::map<std::string, FilmProgress>& film_progress) {
  const Due due{graph, is_due, frames, chunking, film_progress};
  std::vector<Stage> stages = {motions_stage(due), frames_stage(due), films_stage(due),
                               grouped(due, "sheets"), study_stage(due)};
  std::erase_if(stages, [](const Stage& stage) { return stage.elements.empty(); });
  return stages;
}

}  // namespace mien::pipeline
