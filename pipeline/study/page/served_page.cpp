#include "pipeline/study/page/served_page.h"

#include <string_view>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string> page_types = {{".html", "text/html; charset=utf-8"},
                                                       {".css", "text/css; charset=utf-8"},
                                                       {".js", "text/javascript; charset=utf-8"},
                                                       {".json", "application/json; charset=utf-8"},
                                                       {".txt", "text/plain; charset=utf-8"},
                                                       {".svg", "image/svg+xml"},
                                                       {".wasm", "application/wasm"},
                                                       {".woff2", "font/woff2"}};

constexpr std::string_view folder_mode = "name=\"mien-mode\" content=\"static\"";
constexpr std::string_view served_mode = "name=\"mien-mode\" content=\"served\"";

std::string in_served_mode(std::string page, const fs::path& file) {
  const std::size_t at = page.find(folder_mode);
  if (at == page.npos)
    throw Error({file.string()}, "does not declare its mode", "build the pages again");
  return page.replace(at, folder_mode.size(), served_mode);
}

}  // namespace

std::map<std::string, ServedFile> served_page(const fs::path& folder) {
  std::map<std::string, ServedFile> page;
  if (fs::is_directory(folder)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const auto type = page_types.find(entry.path().extension().string());
      if (entry.is_regular_file() && type != page_types.end())
        page[entry.path().filename().string()] = {.bytes = read_file(entry.path()),
                                                  .type = type->second};
    }
  }
  const auto index = page.find("index.html");
  if (index == page.end())
    throw Error({folder.string()}, "contains no page",
                "run ./mien in the source tree, which builds the pages");
  index->second.bytes = in_served_mode(std::move(index->second.bytes), folder / "index.html");
  return page;
}

}  // namespace mien::pipeline
