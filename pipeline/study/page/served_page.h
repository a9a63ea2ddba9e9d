#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mien::pipeline {

/// A file of a page.
struct ServedFile {
  std::string bytes;
  std::string type;          ///< media type: "text/css; charset=utf-8"
  bool webassembly = false;  ///< whether the page may compile WebAssembly
};

/// The files in a page's folder that a browser needs, by name, with `mien-mode` in index.html set
/// to "served". Throws Error if there is no index.html or it does not declare its mode.
std::map<std::string, ServedFile> served_page(const std::filesystem::path& folder);

}  // namespace mien::pipeline
