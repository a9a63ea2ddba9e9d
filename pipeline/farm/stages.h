#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/farm/work_item.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// A part of a stage that one job makes: items in order, each a task ("film:walk") or a chunk of a
/// film's frames ("film:walk[3/12]": the third of twelve).
struct Element {
  std::vector<std::string> items;
  double seconds = 0.0;  ///< estimate
  int frames = 0;        ///< that are drawn or encoded
};

/// What may be made at the same time, once the stages before it are there.
struct Stage {
  std::string name;  ///< "frames"
  std::vector<Element> elements;

  double seconds() const;
};

/// Into how large pieces a study is cut.
struct Cutting {
  int chunk_frames = 0;            ///< an element draws at most so many frames; 0: see below
  double element_seconds = 300.0;  ///< an element takes about so long, or less
  double pace = 1.0;               ///< seconds an estimated second of a task takes
};

/// What is there of a film that is due.
struct FilmPieces {
  std::vector<bool> is_there;  ///< by frame: nobody has to be asked to draw it; or empty
  int chunks = 0;              ///< that it is cut into already; 0: not yet
};

/// The stages motions, frames, films, sheets and study of the tasks that are due (one flag a task),
/// without those that hold nothing. A task is in exactly one element, and the chunks of a film that
/// is drawn in several cover it, but for those of which all frames are there. `frames`: of each
/// film by its task; `pieces` likewise, of films that have been begun.
std::vector<Stage> stages_of(const TaskGraph& graph, const std::vector<bool>& is_due,
                             const std::map<std::string, int>& frames, const Cutting& cutting,
                             const std::map<std::string, FilmPieces>& pieces = {});

/// Stage of a task: "motions", "films", "sheets" or "study".
std::string stage_of(const Task& task);

}  // namespace mien::pipeline
