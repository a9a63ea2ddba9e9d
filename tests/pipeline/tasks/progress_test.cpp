#include "pipeline/tasks/progress.h"

#include <sstream>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TaskGraph three_films() {
  TaskGraph graph;
  for (const char* id : {"film:a", "film:b", "film:c"}) {
    Task task;
    task.id = id;
    task.products = {{id, {}}};
    task.cost_seconds = 10.0;
    graph.add(task);
  }
  return graph;
}

TaskOutcome with_state(TaskState state) {
  TaskOutcome outcome;
  outcome.state = state;
  return outcome;
}

class ProgressTest : public testing::Test {
 protected:
  std::ostringstream out;
  double now = 0.0;
  TaskGraph graph = three_films();
  /// film:c was made before.
  std::vector<TaskOutcome> planned = {with_state(TaskState::due), with_state(TaskState::due),
                                      with_state(TaskState::cached)};

  std::string taken() {
    std::string text = out.str();
    out.str("");
    return text;
  }
};

TEST_F(ProgressTest, TellsPlainLinesRarelyWithoutATerminal) {
  Progress progress(out, false, graph, planned, [this] { return now; });
  const RunObserver observer = progress.observer();
  observer.started(graph.tasks[0]);
  now = 5.0;
  observer.progressed(graph.tasks[0], 0.5);
  EXPECT_EQ(taken(), "");
  now = 10.0;
  observer.progressed(graph.tasks[0], 0.8);
  EXPECT_EQ(taken(), "40 %, 0:15 left\n");
  now = 12.0;
  observer.ended(graph.tasks[0], with_state(TaskState::made));
  EXPECT_EQ(taken(), "film:a made\n");
  observer.ended(graph.tasks[2], with_state(TaskState::cached));
  EXPECT_EQ(taken(), "");
  observer.ended(graph.tasks[1], with_state(TaskState::failed));
  EXPECT_EQ(taken(), "film:b failed\n100 %, 0:00 left\n");
}

/// The first tasks of a plan may take far longer than it thinks: 20 s for 2 % of 20 s are no 16
/// min.
TEST_F(ProgressTest, GoesByThePlanAsLongAsLittleIsDone) {
  Progress progress(out, false, graph, planned, [this] { return now; });
  const RunObserver observer = progress.observer();
  observer.started(graph.tasks[0]);
  now = 20.0;
  observer.progressed(graph.tasks[0], 0.04);
  EXPECT_EQ(taken(), "2 %, 3:08 left\n");
}

TEST_F(ProgressTest, DrawsABarOnATerminalAndTakesItAway) {
  {
    Progress progress(out, true, graph, planned, [this] { return now; });
    const RunObserver observer = progress.observer();
    now = 2.0;
    observer.started(graph.tasks[0]);
    observer.progressed(graph.tasks[0], 0.5);
    now = 4.0;
    observer.progressed(graph.tasks[0], 1.0);
    EXPECT_NE(taken().find("[###############...............] 50 %, 0:04 left  film:a"),
              std::string::npos);
  }
  EXPECT_EQ(taken(), "\r\x1b[K");
}

TEST(Duration, ReadsLikeAClock) {
  EXPECT_EQ(as_duration(0.4), "0:00");
  EXPECT_EQ(as_duration(67.0), "1:07");
  EXPECT_EQ(as_duration(3723.0), "1:02:03");
}

}  // namespace
}  // namespace mien::pipeline
