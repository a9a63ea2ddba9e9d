#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mien::pipeline {

/// The log of an element that was to make an item.
struct ElementLog {
  std::string item;
  std::filesystem::path file;
};

/// The newest log of each element that has the item, of the newest submission that has any: of the
/// task itself and of its chunks where the item is a task ("film:walk"). `folder`: the study's.
std::vector<ElementLog> logs_of(const std::string& item, const std::filesystem::path& folder);

/// Logs of all elements of the newest submission that did not end well.
std::vector<ElementLog> logs_of_ended(const std::filesystem::path& folder);

/// The last lines of a file; only its last 64 KiB are read.
std::string tail_of(const std::filesystem::path& file, int lines);

}  // namespace mien::pipeline
