#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

namespace {

/// A path without its last ".key" or "[index]"; empty for a path of one step.
std::string enclosing(const std::string& path) {
  const std::size_t end = path.find_last_of(".[");
  return end == std::string::npos ? "" : path.substr(0, end);
}

}  // namespace

std::string member_path(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string element_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

Place place_of(const Places& places, std::string path) {
  while (true) {
    if (const auto found = places.values.find(path); found != places.values.end())
      return found->second;
    if (path.empty()) return {};
    path = enclosing(path);
  }
}

Place key_place_of(const Places& places, const std::string& path) {
  const auto found = places.keys.find(path);
  return found == places.keys.end() ? place_of(places, path) : found->second;
}

}  // namespace mien::pipeline
