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

/// The files in a page's folder that a browser needs, by name. In index.html, the meta tag
/// "mien-mode" is changed from "static" to "served". Throws Error if there is no index.html or it
/// has no such tag.
std::map<std::string, ServedFile> served_page(const std::filesystem::path& folder);

}  // namespace mien::pipeline
