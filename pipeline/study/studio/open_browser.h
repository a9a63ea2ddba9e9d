#pragma once

#include <filesystem>
#include <string>

namespace mien::pipeline {

/// A browser that was asked to open a link, where there is a screen and a program that does
/// (xdg-open). The link goes through a file that only its owner may read: what stands on a command
/// line can be read by everybody on the machine. The file is removed at the end.
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
