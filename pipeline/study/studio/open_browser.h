#pragma once

#include <filesystem>
#include <string>

namespace mien::pipeline {

/// Opens a link in a browser with xdg-open if there is a display. The secret link is passed in a
/// file that only its owner can read, since command lines are visible to all users of the machine.
/// The destructor removes the file.
class OpenedBrowser {
 public:
  explicit OpenedBrowser(const std::string& link);
  ~OpenedBrowser();
  OpenedBrowser(const OpenedBrowser&) = delete;
  OpenedBrowser& operator=(const OpenedBrowser&) = delete;

 private:
  std::filesystem::path page_;  ///< empty: nothing was opened
};

}  // namespace mien::pipeline
