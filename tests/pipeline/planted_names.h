#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/tasks/hash.h"

namespace mien::test {

/// Names that lead out of whatever folder they are appended to. `elsewhere` is absolute.
inline std::vector<std::string> planted_names(const std::filesystem::path& elsewhere) {
  return {"../../../planted", elsewhere.string(), "a/../../b", "..", std::string("a\0/../../b", 10),
          "\x1b[2J/../../x"};
}

/// Calls with copies of a document: in each, one text or the name of one member is planted.
inline void each_planted(
    const nlohmann::json& document, const std::vector<std::string>& names,
    const std::function<void(const nlohmann::json&, const std::string&)>& visit) {
  using Pointer = nlohmann::json::json_pointer;
  const std::function<void(const Pointer&)> walk = [&](const Pointer& at) {
    const nlohmann::json value = document[at];
    for (const std::string& name : names) {
      nlohmann::json planted = document;
      if (value.is_string()) {
        planted[at] = name;
        visit(planted, at.to_string() + " = " + name);
      }
      if (!value.is_object()) continue;
      for (const auto& [key, one] : value.items()) {
        nlohmann::json& object = planted[at];
        object.erase(key);
        object[name] = one;
        visit(planted, (at / key).to_string() + " is called " + name);
        planted = document;
      }
    }
    if (value.is_object()) {
      for (const auto& [key, one] : value.items()) walk(at / key);
    }
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) walk(at / i);
    }
  };
  walk(Pointer());
}

/// Contents of a folder except one subfolder: hashes of files, and targets of links.
inline std::map<std::string, std::string> surroundings(const std::filesystem::path& root,
                                                       const std::filesystem::path& but) {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> found;
  for (auto entry = fs::recursive_directory_iterator(root);
       entry != fs::recursive_directory_iterator(); ++entry) {
    if (entry->path() == but) {
      entry.disable_recursion_pending();
    } else if (entry->is_symlink()) {
      found[entry->path().string()] = "-> " + fs::read_symlink(entry->path()).string();
    } else {
      found[entry->path().string()] =
          entry->is_regular_file() ? pipeline::hash_of_file(entry->path()) : "";
    }
  }
  return found;
}

}  // namespace mien::test
