#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/farm/work_item.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The part of a stage that one job does. Each item is a task ("film:walk") or a chunk of a film's
/// frames ("film:walk[3/12]": the third of twelve).
struct Element {
  std::vector<std::string> items;
  double seconds = 0.0;  ///< estimated duration
  int frames = 0;        ///< number of frames rendered or encoded
};

/// A set of elements that can run at the same time, after all earlier stages.
struct Stage {
  std::string name;  ///< "frames"
  std::vector<Element> elements;

  double seconds() const;
};

/// How a study is split into elements.
struct Chunking {
  int chunk_frames = 0;  ///< maximum number of frames per chunk, and per element of several items;
                         ///< 0: by element_seconds
  double element_seconds = 300.0;  ///< intended maximum duration of an element
  double pace = 1.0;               ///< measured seconds per estimated second of a task
};

/// Progress of a film that is due.
struct FilmProgress {
  /// For each frame, whether it is stored or assigned to a queued or running job; may be empty.
  std::vector<bool> has_frame;
  int chunks = 0;  ///< number of chunks used by queued or running jobs (1: not split); 0 if no such
                   ///< job works on it
};

/// Divides the tasks that are due (one flag per task) into the stages motions, frames, films,
/// sheets and study; empty stages are omitted. Each task is in exactly one element. In addition,
/// the frames of a film that is split are divided into chunks, of which those without missing
/// frames (FilmProgress::has_frame) are omitted. `frames`: number of frames of each film by its
/// task; `film_progress`: progress of films that have been started, by task.
std::vector<Stage> stages_of(const TaskGraph& graph, const std::vector<bool>& is_due,
                             const std::map<std::string, int>& frames, const Chunking& chunking,
                             const std::map<std::string, FilmProgress>& film_progress = {});

/// Stage of a task: "motions", "films", "sheets" or "study".
std::string stage_of(const Task& task);

}  // namespace mien::pipeline
