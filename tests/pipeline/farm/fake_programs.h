#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "pipeline/temporary_folder.h"

namespace mien::test {

/// Fake programs that precede all others in PATH during the object's lifetime.
class FakePrograms {
 public:
  enum class Others { found, hidden };

  explicit FakePrograms(Others others = Others::found) : before_(std::getenv("PATH")) {
    const std::string rest = others == Others::found ? ":" + before_ : "";
    ::setenv("PATH", (folder_.path().string() + rest).c_str(), 1);
  }
  ~FakePrograms() { ::setenv("PATH", before_.c_str(), 1); }
  FakePrograms(const FakePrograms&) = delete;
  FakePrograms& operator=(const FakePrograms&) = delete;

  const std::filesystem::path& folder() const { return folder_.path(); }

  /// Adds a shell script.
  void add(const std::string& name, const std::string& script) const {
    const std::filesystem::path file = folder_.path() / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }

  /// Adds a program that only prints `output`.
  void say(const std::string& name, const std::string& output) const {
    write(name + ".output", output);
    add(name, "cat '" + (folder_.path() / (name + ".output")).string() + "'");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }

  std::string text_of(const std::string& name) const {
    std::ifstream file(folder_.path() / name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

 private:
  TemporaryFolder folder_;
  std::string before_;
};

}  // namespace mien::test
