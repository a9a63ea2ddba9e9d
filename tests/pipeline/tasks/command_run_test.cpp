#include "pipeline/tasks/command_run.h"

#include <chrono>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(CommandRun, PassesArgumentsAsTheyAre) {
  const CommandResult end = run_command({"printf", "%s|", "a b", "$HOME", "`id`", "'\"", "", "ü\n"},
                                        std::chrono::seconds(10));
  EXPECT_TRUE(end.succeeded());
  EXPECT_EQ(end.output, "a b|$HOME|`id`|'\"||ü\n|");
}

TEST(CommandRun, KeepsBothOutputsAndTheCode) {
  const CommandResult end =
      run_command({"sh", "-c", "echo out; echo err >&2; exit 7"}, std::chrono::seconds(10));
  EXPECT_EQ(end.code, 7);
  EXPECT_EQ(end.output, "out\n");
  EXPECT_EQ(end.errors, "err\n");
  EXPECT_FALSE(end.succeeded());
}

TEST(CommandRun, TakesMoreThanAPipeHolds) {
  const CommandResult end =
      run_command({"sh", "-c", "yes | head -c 3000000"}, std::chrono::seconds(30));
  EXPECT_EQ(end.output.size(), 3000000u);
}

TEST(CommandRun, TellsASignal) {
  EXPECT_EQ(run_command({"sh", "-c", "kill -9 $$"}, std::chrono::seconds(10)).code, 137);
}

TEST(CommandRun, ReadsNothingFromItsInput) {
  EXPECT_EQ(run_command({"cat"}, std::chrono::seconds(10)).output, "");
}

TEST(CommandRun, TellsThatAProgramIsMissing) {
  EXPECT_TRUE(run_command({"no-such-program-of-anybody"}, std::chrono::seconds(10)).is_missing);
}

TEST(CommandRun, EndsWhatTakesTooLong) {
  const auto begin = std::chrono::steady_clock::now();
  const CommandResult end =
      run_command({"sh", "-c", "echo begun; exec sleep 60"}, std::chrono::milliseconds(300));
  EXPECT_TRUE(end.timed_out);
  EXPECT_EQ(end.output, "begun\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

}  // namespace
}  // namespace mien::pipeline
