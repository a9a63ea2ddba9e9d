#include "pipeline/farm/stages.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "motion/error.h"

namespace mien::pipeline {
namespace {

Task task_of(const std::string& id, const std::string& kind, double seconds) {
  Task task;
  task.id = id;
  task.kind = kind;
  task.products.push_back({id + ".file", {}});
  task.cost_seconds = seconds;
  return task;
}

/// A study of so many films, each of so many seconds.
struct Study {
  TaskGraph graph;
  std::map<std::string, int> frames;

  Study(int films, double seconds, int frame_count) {
    for (int i = 0; i < films; ++i) add("motion:", i, "motion", 0.05);
    graph.add(task_of("exposure", "tables", 2.0));
    for (int i = 0; i < films; ++i) {
      add("clip:", i, "clip", 0.01);
      add("film:", i, "film", seconds);
      frames["film:" + std::to_string(i)] = frame_count;
    }
    for (int i = 0; i < films; ++i) add("sheet:", i, "sheet", 1.0);
    for (const char* id : {"tables", "films"}) graph.add(task_of(id, "tables", 0.1));
    for (const char* id : {"design", "report"}) graph.add(task_of(id, id, 0.1));
  }

  void add(const std::string& prefix, int number, const std::string& kind, double seconds) {
    graph.add(task_of(prefix + std::to_string(number), kind, seconds));
  }
};

/// How often each task is an item, and which frames of which film are drawn how often.
struct Tally {
  std::map<std::string, int> tasks;
  std::map<std::string, std::vector<int>> frames;

  Tally(const std::vector<Stage>& stages, const std::map<std::string, int>& lengths) {
    for (const Stage& stage : stages) {
      for (const Element& element : stage.elements) {
        EXPECT_FALSE(element.items.empty());
        for (const std::string& text : element.items) add(work_item(text), lengths);
      }
    }
  }

  void add(const WorkItem& item, const std::map<std::string, int>& lengths) {
    if (item.chunk == 0) {
      ++tasks[item.task];
      return;
    }
    std::vector<int>& drawn = frames[item.task];
    drawn.resize(static_cast<std::size_t>(lengths.at(item.task)));
    const auto [first, end] = range_of({item.chunk, item.chunks}, lengths.at(item.task));
    for (int frame = first; frame < end; ++frame) ++drawn.at(static_cast<std::size_t>(frame));
  }
};

TEST(Stages, HaveEveryDueTaskOnceAndEveryFrameOfACutFilmOnce) {
  std::mt19937_64 random(16);
  for (int trial = 0; trial < 200; ++trial) {
    const Study study(1 + static_cast<int>(random() % 8),
                      0.5 * static_cast<double>(random() % 4000),
                      1 + static_cast<int>(random() % 300));
    std::vector<bool> is_due;
    for (std::size_t i = 0; i < study.graph.tasks.size(); ++i) is_due.push_back(random() % 3 != 0);
    Chunking chunking;
    chunking.chunk_frames = random() % 2 == 0 ? 0 : 1 + static_cast<int>(random() % 40);
    const std::vector<Stage> stages = stages_of(study.graph, is_due, study.frames, chunking);
    const Tally tally(stages, study.frames);
    for (std::size_t i = 0; i < is_due.size(); ++i) {
      const std::string& id = study.graph.tasks[i].id;
      EXPECT_EQ(tally.tasks.contains(id) ? tally.tasks.at(id) : 0, is_due[i] ? 1 : 0) << id;
    }
    for (const auto& [film, drawn] : tally.frames) {
      EXPECT_EQ(drawn, std::vector<int>(drawn.size(), 1)) << film;
    }
    for (const Stage& stage : stages) {
      for (const Element& element : stage.elements) {
        if (stage.name == "frames" && chunking.chunk_frames > 0) {
          EXPECT_LE(element.frames, chunking.chunk_frames);
        }
      }
    }
  }
}

TEST(Stages, StandInTheOrderInWhichTheyAreMade) {
  const Study study(3, 2000.0, 100);
  const std::vector<bool> all(study.graph.tasks.size(), true);
  std::string names;
  for (const Stage& stage : stages_of(study.graph, all, study.frames, {}))
    names += stage.name + " ";
  EXPECT_EQ(names, "motions frames films sheets study ");
}

TEST(Stages, CutLongFilmsIntoMinutesAndGatherShortOnes) {
  const Study lengthy(2, 3000.0, 1000);
  const std::vector<bool> all(lengthy.graph.tasks.size(), true);
  const std::vector<Stage> cut = stages_of(lengthy.graph, all, lengthy.frames, {});
  ASSERT_EQ(cut[1].name, "frames");
  EXPECT_EQ(cut[1].elements.size(), 20u);
  for (const Element& element : cut[1].elements) EXPECT_NEAR(element.seconds, 270.0, 40.0);

  const Study brief(100, 6.0, 33);
  const std::vector<bool> those(brief.graph.tasks.size(), true);
  const std::vector<Stage> gathered = stages_of(brief.graph, those, brief.frames, {});
  ASSERT_EQ(gathered[1].name, "films");
  EXPECT_EQ(gathered[1].elements.size(), 3u);
}

TEST(Stages, TakeMeasuredPaceForTheEstimate) {
  const Study study(1, 100.0, 100);
  const std::vector<bool> all(study.graph.tasks.size(), true);
  Chunking slow;
  slow.pace = 30.0;
  EXPECT_EQ(stages_of(study.graph, all, study.frames, {})[1].name, "films");
  EXPECT_EQ(stages_of(study.graph, all, study.frames, slow)[1].elements.size(), 10u);
}

TEST(Stages, LetWhatEqualizesFollowTheMotions) {
  const Study study(2, 1.0, 10);
  const std::vector<bool> all(study.graph.tasks.size(), true);
  const Stage motions = stages_of(study.graph, all, study.frames, {}).front();
  ASSERT_EQ(motions.elements.size(), 2u);
  EXPECT_EQ(motions.elements[0].items, (std::vector<std::string>{"motion:0", "motion:1"}));
  EXPECT_EQ(motions.elements[1].items, (std::vector<std::string>{"exposure"}));
}

/// All items of a stage, each followed by a space.
std::string items_of(const std::vector<Stage>& stages, const std::string& name) {
  std::string text;
  for (const Stage& stage : stages) {
    for (const Element& element : stage.elements) {
      for (const std::string& item : element.items) text += stage.name == name ? item + " " : "";
    }
  }
  return text;
}

TEST(Stages, LeaveOutChunksOfWhichAllFramesAreThere) {
  const Study study(1, 1000.0, 40);
  const std::vector<bool> all(study.graph.tasks.size(), true);
  Chunking tens;
  tens.chunk_frames = 10;
  std::map<std::string, FilmProgress> film_progress;
  std::vector<bool>& has_frame = film_progress["film:0"].has_frame;
  has_frame.assign(40, true);
  has_frame[25] = false;
  EXPECT_EQ(items_of(stages_of(study.graph, all, study.frames, tens, film_progress), "frames"),
            "film:0[3/4] ");
  has_frame[25] = true;
  const auto encoding = stages_of(study.graph, all, study.frames, tens, film_progress);
  EXPECT_EQ(items_of(encoding, "frames"), "");
  EXPECT_EQ(items_of(encoding, "films"), "clip:0 film:0 ");
  EXPECT_NEAR(encoding[1].seconds(), 100.0, 1.0);
}

TEST(Stages, KeepACutThatThereIs) {
  const Study study(1, 1000.0, 40);
  const std::vector<bool> all(study.graph.tasks.size(), true);
  std::map<std::string, FilmProgress> film_progress;
  film_progress["film:0"].chunks = 5;
  film_progress["film:0"].has_frame.assign(24, true);
  EXPECT_EQ(items_of(stages_of(study.graph, all, study.frames, {}, film_progress), "frames"),
            "film:0[4/5] film:0[5/5] ");
  film_progress["film:0"].chunks = 1;
  EXPECT_EQ(items_of(stages_of(study.graph, all, study.frames, {}, film_progress), "frames"), "");
}

TEST(WorkItems, SayWhichPartsThereAre) {
  try {
    (void)work_item("film:a[5/2]");
    FAIL() << "is taken for an item";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "\"film:a[5/2]\": of 2 parts there is none with the number 5; they are "
                 "film:a[1/2] to film:a[2/2]");
  }
}

TEST(WorkItems, AreReadAsTheyAreWritten) {
  const WorkItem chunk = work_item(chunk_item("film:a-1.b", 3, 12));
  EXPECT_EQ(chunk.task, "film:a-1.b");
  EXPECT_EQ(chunk.chunk, 3);
  EXPECT_EQ(chunk.chunks, 12);
  EXPECT_EQ(work_item("report").chunk, 0);
  for (const char* wrong : {"", "film:a[0/3]", "film:a[4/3]", "film:a[1/3", "a b", "film:a[1/3]x",
                            "[1/2]", "film:a[99999999999/99999999999]"}) {
    EXPECT_THROW(work_item(wrong), Error) << wrong;
  }
}

TEST(WorkItems, ShareFramesEvenly) {
  EXPECT_EQ(range_of({1, 3}, 10), (std::pair{0, 3}));
  EXPECT_EQ(range_of({2, 3}, 10), (std::pair{3, 6}));
  EXPECT_EQ(range_of({3, 3}, 10), (std::pair{6, 10}));
  EXPECT_EQ(range_of({1'000'000, 1'000'000}, 2'000'000'000).second, 2'000'000'000);
}

}  // namespace
}  // namespace mien::pipeline
