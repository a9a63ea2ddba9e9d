#pragma once

#include <string>

namespace mien::pipeline {

/// A unit of work for a farm's workers: a task ("film:walk"), or a chunk of a film's frames
/// ("film:walk[3/12]": the third of twelve).
struct WorkItem {
  std::string task;
  int chunk = 0;  ///< from 1; 0: the whole task
  int chunks = 0;
};

/// Parses an item's name. Throws Error if it is not one.
WorkItem work_item(const std::string& text);

/// Name of a chunk: "film:walk[3/12]".
std::string chunk_item(const std::string& task, int chunk, int chunks);

}  // namespace mien::pipeline
