#include "motion/text/shell_word.h"

#include <array>
#include <cstdio>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(ShellWord, LeavesPlainPathsAsTheyAre) {
  EXPECT_EQ(shell_path("out/my-study_2.yaml"), "out/my-study_2.yaml");
  EXPECT_EQ(shell_path("/shared/études/歩く.yaml"), "/shared/études/歩く.yaml");
}

TEST(ShellWord, QuotesWhatAShellWouldTakeApart) {
  EXPECT_EQ(shell_path("my study.yaml"), "'my study.yaml'");
  EXPECT_EQ(shell_path("a;rm -rf ~.yaml"), "'a;rm -rf ~.yaml'");
  EXPECT_EQ(shell_path("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_path("$(id)"), "'$(id)'");
  EXPECT_EQ(shell_path(""), "''");
  EXPECT_EQ(shell_path("~"), "'~'");
}

TEST(ShellWord, DoesNotLetAPathBeAnOption) {
  EXPECT_EQ(shell_path("--force"), "./--force");
  EXPECT_EQ(shell_word("--force"), "--force");
}

TEST(ShellWord, CanBeShownWhateverIsInIt) {
  EXPECT_EQ(shell_path("a\x1b[2J\nb"), "$'a\\033[2J\\012b'");
}

/// What bash makes of the words of a command line, each with a zero byte after it.
std::string read_by_bash(const std::string& words) {
  setenv("MIEN_TEST_COMMAND", ("printf '%s\\0' " + words).c_str(), 1);
  std::FILE* const pipe = popen("bash -c \"$MIEN_TEST_COMMAND\"", "r");
  std::string read;
  std::array<char, 4096> piece;
  for (std::size_t count = 0; (count = fread(piece.data(), 1, piece.size(), pipe)) > 0;)
    read.append(piece.data(), count);
  pclose(pipe);
  return read;
}

TEST(ShellWord, IsTheTextAgainToAShell) {
  const std::vector<std::string> pieces = {"a",  " ", "'", "\"", "\\", "$", "`", "!", "\n",  "\x1b",
                                           "\t", "é", "*", "~",  "#",  "&", "7", "%", "\xff"};
  std::mt19937_64 random(5);
  std::string words, expected;
  for (int i = 0; i < 500; ++i) {
    std::string text;
    for (std::size_t count = random() % 12; count > 0; --count)
      text += pieces[random() % pieces.size()];
    words += shell_word(text) + " ";
    expected += text + std::string(1, '\0');
  }
  EXPECT_EQ(read_by_bash(words), expected);
}

}  // namespace
}  // namespace mien::motion
