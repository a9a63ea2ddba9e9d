#pragma once

#include <filesystem>
#include <string>

#include "end_to_end/page.h"
#include "end_to_end/program.h"

namespace mien::test {

/// A scratch folder that looks as the pages suppose: ./mien, manifests/, and the files that they
/// speak of (walk.bvh, captures/, answers.csv, …), small and made by the program itself. Nothing in
/// it was captured, and nobody answered anything.
class PageFolder {
 public:
  PageFolder();

  /// Runs a command of a page there, as a shell does.
  Ended run(const std::string& command) const;

  const std::filesystem::path& path() const { return scratch_.path(); }
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  Scratch scratch_;
};

/// The command as it is run here: pictures are few, small and drafts, ready-made manifests are
/// planned in place of run, and what is piped into jq is not.
std::string made_cheap(const std::string& command);

/// A manifest out of a part of one. What is missing is added: built-in examples, two stimuli; what
/// only a stimulus can have becomes part of one.
std::string completed(const std::string& yaml);

}  // namespace mien::test
