#pragma once

#include <string>

namespace mien::pipeline {

/// A piece of work that a farm hands out: a task ("film:walk"), or a chunk of a film's frames
/// ("film:walk[3/12]": the third of twelve).
struct WorkItem {
  std::string task;
  int chunk = 0;  ///< from 1; 0: the whole task
  int chunks = 0;
};

/// Throws Error when the text is none.
WorkItem work_item(const std::string& text);

/// The chunk's item: "film:walk[3/12]".
std::string chunk_item(const std::string& task, int chunk, int chunks);

}  // namespace mien::pipeline
