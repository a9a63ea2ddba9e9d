// Results that cannot be written: files and standard output.

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// A command of the shell in which $1 … are the words of a mien command.
Ended shell(const std::string& script, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"bash", "-c", script, "bash"};
  const std::vector<std::string> mien = mien_with(arguments);
  words.insert(words.end(), mien.begin(), mien.end());
  return run_program(words);
}

TEST(StandardOutput, ThatIsFullIsAFailureThatIsTold) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{"--help"},
                                                  {"version"},
                                                  {"man"},
                                                  {"completion", "bash"},
                                                  {"manifests", "quickstart"},
                                                  {"sets"}}) {
    const Ended ended = shell("\"$@\" >/dev/full", command);
    EXPECT_EQ(ended.code, 1) << command.front();
    EXPECT_EQ(ended.errors, "mien: standard output cannot be written (No space left on device)\n")
        << command.front();
  }
}

TEST(StandardOutput, ThatIsClosedIsAFailureAndNoFileTakesItsPlace) {
  const Ended ended = shell("\"$@\" >&-", {"manifests", "quickstart"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.errors, "mien: standard output cannot be written (Bad file descriptor)\n");
}

TEST(StandardOutput, OfWhichSomebodyReadsTheBeginningIsNone) {
  const Ended ended = shell("set -o pipefail; \"$@\" | head -c 1 >/dev/null", {"man"});
  EXPECT_EQ(ended.code, 0) << ended.errors;
  EXPECT_EQ(ended.errors, "");
}

TEST(Results, ThatCannotBeWrittenLeaveTheOlderFileAndNothingElse) {
  const Scratch scratch;
  const std::string walk = (scratch.path() / "walk.bvh").string();
  ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights", "normal=1",
                      "-o", walk})
                .code,
            0);
  const fs::path older = scratch.write("older.bvh", "older");
  const std::string before = text_of(older);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"motion", "convert", walk, older.string()},
        {"motion", "modify", walk, "sad", older.string()},
        {"motion", "blend", "--examples", "builtin:walks-10", "--weights", "normal=1", "-o",
         older.string()}}) {
    // Files of at most 1024 bytes, as on a disk that is full.
    const Ended ended = shell("trap '' XFSZ; ulimit -f 1; \"$@\"", command);
    EXPECT_EQ(ended.code, 1) << command[1];
    EXPECT_EQ(ended.errors, "mien: " + older.string() + ": cannot be written (File too large)\n");
    EXPECT_EQ(text_of(older), before) << command[1];
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 2);
}

}  // namespace
}  // namespace mien::test
