#include <gtest/gtest.h>

#include "pipeline/production/run/run.h"

namespace mien::pipeline {
namespace {

RunResult ended_with(const std::vector<std::pair<TaskState, int>>& states) {
  RunResult result;
  for (const auto& [state, count] : states) {
    for (int i = 0; i < count; ++i) result.outcomes.emplace_back().state = state;
  }
  return result;
}

TEST(CountedTasks, OfAnInterruptedRunAreAllThatAreLeft) {
  RunResult result =
      ended_with({{TaskState::made, 7}, {TaskState::interrupted, 16}, {TaskState::skipped, 3}});
  result.was_interrupted = true;
  EXPECT_EQ(counted_tasks(result),
            "7 tasks done, 19 left; interrupted: run the same command again to continue");
}

TEST(CountedTasks, OfARunThatFailedAreWhatWasNotBegun) {
  EXPECT_EQ(counted_tasks(ended_with({{TaskState::made, 1},
                                      {TaskState::cached, 2},
                                      {TaskState::failed, 1},
                                      {TaskState::skipped, 3}})),
            "1 task done, 2 up to date, 1 failed, 3 skipped because they depend on it");
}

TEST(CountedTasks, OfAFinishedStudyAreNothingToDo) {
  EXPECT_EQ(counted_tasks(ended_with({{TaskState::cached, 4}})),
            "nothing to do, all 4 tasks are done");
  EXPECT_EQ(counted_tasks(ended_with({{TaskState::made, 4}})), "4 tasks done");
}

}  // namespace
}  // namespace mien::pipeline
