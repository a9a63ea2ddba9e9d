#include "pipeline/tasks/task_graph.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <barrier>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// A task that writes its inputs' texts and its own word.
Task writing_task(const std::string& id, const std::vector<std::string>& inputs,
                  const std::string& word) {
  Task task;
  task.id = id;
  task.kind = "text";
  task.inputs = inputs;
  task.determinants.add("word", word);
  task.products = {{id + ".txt", {}}};
  task.cost_seconds = 1.0;
  task.make = [inputs, word](TaskRun& run) {
    std::string text = word;
    for (const std::string& input : inputs) {
      text += "(" + read_file(run.store.folder() / (input + ".txt")) + ")";
    }
    run.store.put(
        run.task.products[0].path, run.keys[0],
        [&](const fs::path& file) { write_file(file, text); }, [](const fs::path&) {});
  };
  return task;
}

class TaskGraphTest : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "study";
  std::stop_source stop;
  std::vector<std::string> made;  ///< ids, in the order in which they ended

  std::vector<TaskOutcome> run_all(const TaskGraph& graph, int jobs = 2) {
    Store store(folder);
    made.clear();
    RunObserver observer;
    observer.ended = [&](const Task& task, const TaskOutcome& outcome) {
      if (outcome.state == TaskState::made) made.push_back(task.id);
    };
    return run(graph, store, jobs, stop.get_token(), observer);
  }
};

/// a → b → d, a → c → d
TaskGraph diamond(const std::string& word_of_a, const std::string& word_of_b = "b") {
  TaskGraph graph;
  graph.add(writing_task("a", {}, word_of_a));
  graph.add(writing_task("b", {"a"}, word_of_b));
  graph.add(writing_task("c", {"a"}, "c"));
  graph.add(writing_task("d", {"b", "c"}, "d"));
  return graph;
}

TEST_F(TaskGraphTest, WaitsForWhatIsNoInputAndDoesNotDependOnItsBytes) {
  const auto graph_with = [](const std::string& word) {
    TaskGraph graph;
    graph.add(writing_task("gate", {}, word));
    graph.add(writing_task("behind", {}, "behind"));
    graph.tasks.back().after = {"gate"};
    return graph;
  };
  run_all(graph_with("open"), 7);
  EXPECT_EQ(made, (std::vector<std::string>{"gate", "behind"}));
  run_all(graph_with("still open"), 7);
  EXPECT_EQ(made, std::vector<std::string>{"gate"});
  TaskGraph closed = graph_with("closed");
  closed.tasks[0].make = [](TaskRun&) { throw Error("closed", "open it"); };
  EXPECT_EQ(run_all(closed, 7)[1].state, TaskState::skipped);
}

TEST_F(TaskGraphTest, MakesInputsFirst) {
  for (const int jobs : {1, 2, 7}) {
    const TaskGraph graph = diamond("a" + std::to_string(jobs));
    run_all(graph, jobs);
    ASSERT_EQ(made.size(), 4u);
    EXPECT_EQ(made.front(), "a");
    EXPECT_EQ(made.back(), "d");
    const std::string a = "a" + std::to_string(jobs);
    EXPECT_EQ(read_file(folder / "d.txt"), "d(b(" + a + "))(c(" + a + "))");
  }
}

TEST_F(TaskGraphTest, DoesNothingTwice) {
  run_all(diamond("a"));
  const std::vector<TaskOutcome> outcomes = run_all(diamond("a"));
  EXPECT_TRUE(made.empty());
  for (const TaskOutcome& outcome : outcomes) EXPECT_EQ(outcome.state, TaskState::cached);
}

TEST_F(TaskGraphTest, MakesAgainWhatDependsOnAChange) {
  run_all(diamond("a"));
  run_all(diamond("a", "b2"));
  std::sort(made.begin(), made.end());
  EXPECT_EQ(made, (std::vector<std::string>{"b", "d"}));
  fs::remove(folder / "c.txt");
  run_all(diamond("a", "b2"));
  EXPECT_EQ(made, (std::vector<std::string>{"c"}));
}

TEST_F(TaskGraphTest, StopsAtAnInputThatCameOutTheSame) {
  TaskGraph before;
  before.add(writing_task("a", {}, "same"));
  before.add(writing_task("b", {"a"}, "b"));
  run_all(before);
  TaskGraph after;
  Task changed = writing_task("a", {}, "same");
  changed.determinants.add("code", "changed");
  after.add(changed);
  after.add(writing_task("b", {"a"}, "b"));
  run_all(after);
  EXPECT_EQ(made, (std::vector<std::string>{"a"}));
}

TEST_F(TaskGraphTest, PlansWithoutMaking) {
  const auto states = [&](const TaskGraph& graph) {
    std::vector<TaskState> list;
    for (const TaskOutcome& outcome : plan(graph, folder)) list.push_back(outcome.state);
    return list;
  };
  using enum TaskState;
  EXPECT_EQ(states(diamond("a")), (std::vector{due, waiting, waiting, waiting}));
  EXPECT_FALSE(fs::exists(folder));
  run_all(diamond("a"));
  EXPECT_EQ(states(diamond("a")), (std::vector{cached, cached, cached, cached}));
  EXPECT_EQ(states(diamond("a", "b2")), (std::vector{cached, due, cached, waiting}));
}

TEST_F(TaskGraphTest, AFailureStopsOnlyWhatDependsOnIt) {
  TaskGraph graph;
  graph.add(writing_task("a", {}, "a"));
  Task broken = writing_task("b", {"a"}, "b");
  broken.make = [](TaskRun&) { throw std::runtime_error("the disk is full"); };
  graph.add(broken);
  graph.add(writing_task("c", {"a"}, "c"));
  graph.add(writing_task("d", {"b", "c"}, "d"));
  graph.add(writing_task("e", {"d"}, "e"));
  const auto outcomes = run_all(graph);
  EXPECT_EQ(outcomes[1].state, TaskState::failed);
  EXPECT_EQ(outcomes[1].error, "the disk is full");
  EXPECT_FALSE(outcomes[1].is_bad_input);
  EXPECT_EQ(outcomes[2].state, TaskState::made);
  EXPECT_EQ(outcomes[3].state, TaskState::skipped);
  EXPECT_EQ(outcomes[4].state, TaskState::skipped);
}

TEST_F(TaskGraphTest, TellsBadInputFromAFailingMachine) {
  TaskGraph graph;
  Task broken = writing_task("a", {}, "a");
  broken.make = [](TaskRun&) { throw Error({"walk.bvh", 3, 1}, "no joints", "add some"); };
  graph.add(broken);
  const auto outcomes = run_all(graph);
  EXPECT_TRUE(outcomes[0].is_bad_input);
  EXPECT_EQ(outcomes[0].error, "walk.bvh:3:1: no joints; add some");
}

TEST_F(TaskGraphTest, AMessageNamesAFileWithoutTheFolderOfItsAttempt) {
  TaskGraph graph;
  Task broken = writing_task("a", {}, "a");
  broken.make = [](TaskRun& run) {
    run.store.put("a.txt", run.keys[0],
                  [](const fs::path& file) {
                    throw std::runtime_error(file.string() + ": no space left, " + file.string());
                  },
                  {});
  };
  graph.add(broken);
  EXPECT_EQ(run_all(graph)[0].error, "a.txt: no space left, a.txt");
}

TEST_F(TaskGraphTest, AProductThatWasNotMadeIsAFailure) {
  TaskGraph graph;
  Task lazy = writing_task("a", {}, "a");
  lazy.make = [](TaskRun&) {};
  graph.add(lazy);
  EXPECT_EQ(run_all(graph)[0].state, TaskState::failed);
}

TEST_F(TaskGraphTest, AfterAStopRequestNothingIsBegunAndTheRestGoesOnLater) {
  const auto graph_that_stops = [&](bool stops) {
    TaskGraph graph;
    Task first = writing_task("a", {}, "a");
    first.make = [this, stops, make = first.make](TaskRun& run) {
      make(run);
      if (stops) stop.request_stop();
    };
    graph.add(first);
    graph.add(writing_task("b", {"a"}, "b"));
    graph.add(writing_task("c", {}, "c"));
    return graph;
  };
  const auto outcomes = run_all(graph_that_stops(true), 1);
  EXPECT_EQ(outcomes[0].state, TaskState::made);
  EXPECT_EQ(outcomes[1].state, TaskState::interrupted);
  EXPECT_EQ(outcomes[2].state, TaskState::interrupted);
  stop = {};
  run_all(graph_that_stops(false));
  std::sort(made.begin(), made.end());
  EXPECT_EQ(made, (std::vector<std::string>{"b", "c"}));
}

TEST_F(TaskGraphTest, ATaskThatGivesUpIsInterruptedNotFailed) {
  TaskGraph graph;
  Task task = writing_task("a", {}, "a");
  task.make = [](TaskRun&) { throw Interrupted{}; };
  graph.add(task);
  EXPECT_EQ(run_all(graph)[0].state, TaskState::interrupted);
}

TEST_F(TaskGraphTest, AProductsOwnDeterminantsConcernNoOtherProduct) {
  Task task;
  task.kind = "film";
  task.products = {{"frames", {}}, {"video", {}}};
  const std::vector<Hash> before = keys_of(task, {});
  task.products[1].own.add("crf", 20.0);
  const std::vector<Hash> after = keys_of(task, {});
  EXPECT_EQ(before[0], after[0]);
  EXPECT_NE(before[1], after[1]);
  EXPECT_NE(before[0], before[1]);
}

TEST_F(TaskGraphTest, TwoRunsShareTheWork) {
  std::atomic<int> begun = 0;
  TaskGraph graph;
  for (int i = 0; i < 12; ++i) {
    Task task = writing_task("t" + std::to_string(i), {}, "word");
    task.make = [&begun, make = task.make](TaskRun& task_run) {
      ++begun;
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      make(task_run);
    };
    graph.add(std::move(task));
  }
  graph.add(writing_task("last", {"t0", "t11"}, "last"));
  std::array<int, 2> made_by{};
  std::barrier both_there(2);
  {
    std::vector<std::jthread> runs;
    for (int& count : made_by) {
      runs.emplace_back([&] {
        Store store(folder);
        both_there.arrive_and_wait();
        for (const TaskOutcome& outcome : run(graph, store, 1, stop.get_token(), {})) {
          if (outcome.state == TaskState::made) ++count;
          EXPECT_FALSE(outcome.products.empty());
        }
      });
    }
  }
  EXPECT_EQ(begun, 12);
  EXPECT_EQ(made_by[0] + made_by[1], 13);
  EXPECT_GT(made_by[0], 0);
  EXPECT_GT(made_by[1], 0);
}

TEST_F(TaskGraphTest, TriesAgainWhatTheMachineMadeFail) {
  for (const int failures : {2, 3}) {
    int tries = 0;
    TaskGraph graph;
    Task task = writing_task("a", {}, "word " + std::to_string(failures));
    task.make = [&, make = task.make](TaskRun& task_run) {
      if (++tries <= failures) throw WriteFailure("the server is away");
      make(task_run);
    };
    graph.add(task);
    const TaskOutcome outcome = run_all(graph)[0];
    EXPECT_EQ(tries, 3);
    EXPECT_EQ(outcome.state, failures == 2 ? TaskState::made : TaskState::failed);
    EXPECT_EQ(outcome.is_transient, failures == 3);
  }
}

TEST_F(TaskGraphTest, KnowsWhatTheDiskMadeFailWhoeverFoundOut) {
  const std::error_code full(ENOSPC, std::generic_category());
  const auto outcome_of = [&](const auto& error) {
    TaskGraph graph;
    Task task = writing_task("a", {}, "word");
    task.make = [&](TaskRun&) { throw error; };
    graph.add(task);
    return run_all(graph)[0];
  };
  for (const TaskOutcome& outcome :
       {outcome_of(WriteFailure("full", full)), outcome_of(std::system_error(full)),
        outcome_of(DiskFault("the disk is full"))}) {
    EXPECT_TRUE(outcome.is_disk_fault);
    EXPECT_TRUE(outcome.is_transient);
  }
  const TaskOutcome of_unknown_cause = outcome_of(WriteFailure("away"));
  EXPECT_FALSE(of_unknown_cause.is_disk_fault);
  EXPECT_TRUE(of_unknown_cause.is_transient);
}

TEST_F(TaskGraphTest, TwoRunsThatTakeTurnsInFailingComeToAnEnd) {
  std::atomic<int> tries = 0;
  TaskGraph graph;
  Task task = writing_task("a", {}, "word");
  task.make = [&](TaskRun&) {
    ++tries;
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    throw WriteFailure("the server is away");
  };
  graph.add(task);
  {
    std::vector<std::jthread> runs;
    for (int i = 0; i < 2; ++i) {
      runs.emplace_back([&] {
        Store store(folder);
        EXPECT_EQ(run(graph, store, 1, stop.get_token(), {})[0].state, TaskState::failed);
      });
    }
  }
  EXPECT_EQ(tries, 6);
}

TEST_F(TaskGraphTest, TriesOnceWhatWouldFailAgain) {
  int tries = 0;
  TaskGraph graph;
  Task task = writing_task("a", {}, "a");
  task.make = [&](TaskRun&) {
    ++tries;
    throw std::logic_error("a mistake of ours");
  };
  graph.add(task);
  EXPECT_EQ(run_all(graph)[0].state, TaskState::failed);
  EXPECT_EQ(tries, 1);
}

TEST_F(TaskGraphTest, APartOfATaskIsDoneForTheTaskOfTheSameKey) {
  std::string key_of_part;
  std::string key_of_whole;
  int parts = 0;
  TaskGraph graph;
  graph.add(writing_task("a", {}, "a"));
  Task whole = writing_task("film", {"a"}, "film");
  whole.make = [&, make = whole.make](TaskRun& task_run) {
    key_of_whole = task_run.task_key;
    make(task_run);
  };
  whole.make_part = [&](TaskRun& task_run, const Part& part) {
    EXPECT_EQ(part, (Part{2, 3}));
    EXPECT_EQ(task_run.task.id, "film");
    key_of_part = task_run.task_key;
    ++parts;
  };
  graph.add(whole);
  const Task part = part_of(graph.task("film"), {2, 3});
  EXPECT_EQ(part.id, "film[2/3]");
  TaskGraph items;
  items.add(graph.task("a"));
  items.add(part);
  Task after = graph.task("film");
  after.inputs.push_back(part.id);
  items.add(after);
  EXPECT_EQ(run_all(items)[1].state, TaskState::made);
  EXPECT_EQ(key_of_part, key_of_whole);
  run_all(items);
  EXPECT_EQ(parts, 1);  // what is made needs no parts
}

}  // namespace
}  // namespace mien::pipeline
