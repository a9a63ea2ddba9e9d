#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mien::pipeline {

/// A file of a page.
struct ServedFile {
  std::string bytes;
  std::string type;          ///< of its content: "text/css; charset=utf-8"
  bool webassembly = false;  ///< a page that may compile WebAssembly
};

/// The files of a page's folder that a browser needs, by name, as they are served: index.html,
/// which is the page itself, says in its `mien-mode` that it is. Throws Error when there is none.
std::map<std::string, ServedFile> served_page(const std::filesystem::path& folder);

}  // namespace mien::pipeline
