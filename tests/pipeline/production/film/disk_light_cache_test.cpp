#include "pipeline/production/film/disk_light_cache.h"

#include <filesystem>
#include <fstream>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/production/film/drawn_frames.h"
#include "pipeline/tasks/receipt.h"
#include "pipeline/tasks/task_graph.h"
#include "pipeline/temporary_folder.h"
#include "scenes/sets/set_plan.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// A walk beside a box.
scenes::Shot walk_beside_a_box(const std::string& view = "three-quarter") {
  scenes::Look look;
  look.size = {48, 32};
  look.camera.view = view;
  look.set.ground = render::Ground{};
  look.set.lights = {{}};
  look.set.boxes = {{.centre = {0.5, 0.3, -0.5}, .size = {0.6, 0.6, 0.6}}};
  const motion::Clip clip = motion::builtin_examples("walks-10", 10.0).examples[0].clip;
  return scenes::stage(motion::repeated(clip, 1), look);
}

using test::Pictures;

class KeptLight : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "study";
  std::stop_source stop;

  static FilmSettings settings(int threads = 1) {
    FilmSettings result;
    result.output.size = {48, 32};
    result.output.quality = Quality::draft;
    result.threads = threads;
    return result;
  }

  Pictures drawn(const scenes::Shot& shot, const FilmSettings& how, int first, int end) {
    std::vector<int> frames(static_cast<std::size_t>(end - first));
    std::iota(frames.begin(), frames.end(), first);
    return test::drawn_frames(shot, frames, how);
  }

  /// How often light is drawn, and not found.
  render::LightCache counted(render::LightCache keep) {
    return [this, keep](const std::string& name, const std::function<render::Framebuffer()>& draw) {
      return keep(name, [&] {
        ++times_drawn;
        return draw();
      });
    };
  }

  std::vector<fs::path> kept_files() const {
    std::vector<fs::path> files;
    std::error_code none;
    for (fs::directory_iterator entry(folder / ".mien/light", none);
         !none && entry != fs::directory_iterator(); entry.increment(none))
      files.push_back(entry->path());
    return files;
  }

  int times_drawn = 0;
};

TEST_F(KeptLight, IsDrawnOnceAStudyAndChangesNoPicture) {
  const scenes::Shot shot = walk_beside_a_box();
  const int count = shot.frame_count();
  const Pictures alone = drawn(shot, settings(), 0, count);
  for (const int threads : {1, 2}) {
    Store store(folder);  // a run of its own
    FilmSettings how = settings(threads);
    how.light_cache = counted(disk_light_cache(store, stop.get_token()));
    EXPECT_EQ(drawn(shot, how, 0, count), alone) << threads;
  }
  Store store(folder);
  FilmSettings how = settings();
  how.light_cache = counted(disk_light_cache(store, stop.get_token()));
  Pictures parts = drawn(shot, how, 0, count / 2);
  parts.merge(drawn(shot, how, count / 2, count));
  EXPECT_EQ(parts, alone);
  EXPECT_EQ(times_drawn, 1);
  EXPECT_EQ(kept_files().size(), 1u);
}

TEST_F(KeptLight, IsNotOfSetsThatMoveWithEveryFrame) {
  const scenes::Shot shot = walk_beside_a_box("follow");
  render::StaticBackgroundCache sets;
  Store store(folder);
  FilmSettings how = settings();
  how.sets = &sets;
  how.light_cache = counted(disk_light_cache(store, stop.get_token()));
  drawn(shot, how, 0, 2);
  EXPECT_EQ(times_drawn, 0);
  EXPECT_TRUE(kept_files().empty());
}

render::Framebuffer light_of(float value) {
  render::Framebuffer light(3, 2);
  light.channels.assign(light.channels.size(), value);
  return light;
}

TEST_F(KeptLight, IsDrawnAgainWhenItsFileIsNotAsItWasWritten) {
  {
    Store store(folder);
    disk_light_cache(store, {})("a", [] { return light_of(0.25f); });
  }
  const fs::path file = kept_files().at(0);
  fs::resize_file(file, fs::file_size(file) - 1);
  Store store(folder);
  const render::LightCache keep = counted(disk_light_cache(store, {}));
  EXPECT_EQ(keep("a", [] { return light_of(0.25f); }), light_of(0.25f));
  EXPECT_EQ(times_drawn, 1);
  {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(20);
    bytes.put('x');
  }
  EXPECT_EQ(keep("a", [] { return light_of(0.25f); }), light_of(0.25f));
  EXPECT_EQ(times_drawn, 2);
  EXPECT_EQ(keep("a", [] { return light_of(0.25f); }), light_of(0.25f));
  EXPECT_EQ(times_drawn, 2);
  EXPECT_TRUE(store.nondeterminism().empty());
}

TEST_F(KeptLight, GivesWayToWhatWasUsedLater) {
  Store store(folder);
  const std::uintmax_t bytes_of_two = 2 * (8 + 3 * 2 * 3 * sizeof(float));
  const render::LightCache keep = counted(disk_light_cache(store, {}, bytes_of_two));
  const auto ask = [&](const std::string& name) {
    keep(name, [] { return light_of(0.5f); });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // files' times are coarse
  };
  for (const char* name : {"a", "b", "a", "c"}) ask(name);
  EXPECT_EQ(times_drawn, 3);
  EXPECT_EQ(kept_files().size(), 2u);
  ask("a");
  EXPECT_EQ(times_drawn, 3) << "used after b";
  ask("b");
  EXPECT_EQ(times_drawn, 4);
  EXPECT_FALSE(read_receipt(folder, ".mien/light/c")) << "nor does its receipt stay";
}

TEST_F(KeptLight, ThatAnotherProcessDrawsIsNotWaitedForAfterAStop) {
  Store other(folder), store(folder);
  const auto claim = other.claim("light a");
  ASSERT_TRUE(claim);
  stop.request_stop();
  EXPECT_THROW(disk_light_cache(store, stop.get_token())("a", [] { return light_of(0.5f); }),
               Interrupted);
}

TEST_F(KeptLight, IsNotThereWhenItsDrawingFails) {
  Store store(folder);
  const auto fail = []() -> render::Framebuffer { throw render::Stopped{}; };
  EXPECT_THROW(disk_light_cache(store, {})("a", fail), render::Stopped);
  EXPECT_TRUE(kept_files().empty());
  EXPECT_EQ(disk_light_cache(store, {})("a", [] { return light_of(0.5f); }), light_of(0.5f));
}

}  // namespace
}  // namespace mien::pipeline
