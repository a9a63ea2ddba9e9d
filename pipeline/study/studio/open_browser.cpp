#include "pipeline/study/studio/open_browser.h"

#include <array>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/server/session_store.h"

extern char** environ;

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// A page that redirects to the link.
std::string sending_page(const std::string& link) {
  const std::string escaped = html_escaped(link);
  return "<!doctype html><meta charset=\"utf-8\"><title>mien studio</title>"
         "<meta http-equiv=\"refresh\" content=\"0; url=" +
         escaped + "\"><a href=\"" + escaped + "\">mien studio</a>\n";
}

bool write_private(const fs::path& file, std::string_view text) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) return false;
  const bool is_whole =
      ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(descriptor);
  return is_whole;
}

/// Starts xdg-open without waiting, its output discarded.
bool open_by_desktop(const fs::path& file) {
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  for (const int descriptor : {0, 1, 2})
    posix_spawn_file_actions_addopen(&quiet, descriptor, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", name = file.string();
  std::array<char*, 3> arguments = {program.data(), name.data(), nullptr};
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, program.c_str(), &quiet, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&quiet);
  return error == 0;
}

}  // namespace

OpenedBrowser::OpenedBrowser(const std::string& link) {
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) return;
  std::error_code unknown;
  const fs::path folder = fs::temp_directory_path(unknown);
  if (unknown) return;
  const fs::path page = folder / ("mien-studio-" + random_link() + ".html");
  if (!write_private(page, sending_page(link))) return;
  page_ = page;
  open_by_desktop(page);
}

OpenedBrowser::~OpenedBrowser() {
  std::error_code ignored;
  if (!page_.empty()) fs::remove(page_, ignored);
}

}  // namespace mien::pipeline
