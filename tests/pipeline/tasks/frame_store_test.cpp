#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/store.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> names = {"0.png", "1.png", "2.png", "3.png"};

class FrameStoreTest : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "study";
  int drawn = 0;

  /// Draws the frames that are not there, up to `stop_after` of them, and publishes a whole film.
  void film(Store& store, const Hash& key, int stop_after = 100) {
    const auto frames = store.frames("frames/a", key);
    for (const std::string& name : names) {
      if (frames->find(name)) continue;
      if (stop_after-- == 0) return;
      ++drawn;
      frames->put(
          name, [&](const fs::path& file) { write_file(file, key + name); },
          [](const fs::path&) {});
    }
    frames->publish(names);
  }

  std::map<std::string, std::string> published() const {
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::directory_iterator(folder / "frames/a")) {
      texts[entry.path().filename()] = read_file(entry.path());
    }
    return texts;
  }

  /// Files that were set aside, by their names.
  std::map<std::string, std::string> set_aside() const {
    std::map<std::string, std::string> texts;
    const fs::path aside = folder / ".mien/set-aside";
    if (!fs::exists(aside)) return texts;
    for (const auto& entry : fs::recursive_directory_iterator(aside)) {
      if (entry.is_regular_file()) texts[entry.path().filename()] = read_file(entry.path());
    }
    return texts;
  }
};

TEST_F(FrameStoreTest, PublishesAllFramesAtOnce) {
  Store store(folder);
  film(store, "k", 3);
  EXPECT_FALSE(fs::exists(folder / "frames/a"));
  film(store, "k");
  EXPECT_EQ(published().size(), 4u);
  const auto receipt = store.find("frames/a", "k");
  ASSERT_TRUE(receipt);
  EXPECT_EQ(receipt->frames.size(), 4u);
  EXPECT_EQ(receipt->size, 4 * 6u);
}

TEST_F(FrameStoreTest, GoesOnWhereAKilledRunStopped) {
  {
    Store store(folder);
    film(store, "k", 2);
  }
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 4);
  EXPECT_TRUE(store.find("frames/a", "k"));
}

TEST_F(FrameStoreTest, DrawsAgainWhatWasDamagedInBetween) {
  {
    Store store(folder);
    film(store, "k", 3);
  }
  write_file(folder / ".mien/partial/frames/a/k/frames/1.png", "damaged");
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 5);
  EXPECT_EQ(published().at("1.png"), "k1.png");
  EXPECT_TRUE(store.nondeterminism().empty());
}

TEST_F(FrameStoreTest, SetsAsideWhatLiesInThePlaceOfItsWorkings) {
  const fs::path sequence = folder / ".mien/partial/frames/a/k";
  for (const fs::path& place : {sequence / "frames/1.png", sequence / "frames", sequence}) {
    SCOPED_TRACE(place);
    fs::remove_all(folder);
    film(*std::make_unique<Store>(folder), "k", 3);
    fs::remove_all(place);
    if (place.extension() == ".png") {
      fs::create_directories(place / "of the user");
    } else {
      write_file(place, "of the user");
    }
    Store store(folder);
    film(store, "k");
    EXPECT_TRUE(store.find("frames/a", "k"));
    EXPECT_EQ(published().size(), names.size());
    bool is_told = false;
    for (const std::string& repair : store.repairs())
      is_told = is_told || repair.find(".mien/set-aside/") != std::string::npos;
    EXPECT_TRUE(is_told);
  }
}

/// The only file of notes in the sequence's folder.
fs::path notes_in(const fs::path& sequence) {
  return fs::directory_iterator(sequence / "notes")->path();
}

TEST_F(FrameStoreTest, ReadsNotesUpToWhereTheyWereCutOff) {
  {
    Store store(folder);
    film(store, "k", 3);
  }
  const fs::path notes = notes_in(folder / ".mien/partial/frames/a/k");
  const std::string text = read_file(notes);
  write_file(notes, text.substr(0, text.size() - 20));
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 5);
  EXPECT_TRUE(store.find("frames/a", "k"));
}

TEST_F(FrameStoreTest, BelievesNoNoteThatWasChanged) {
  {
    Store store(folder);
    film(store, "k", 3);
  }
  const fs::path notes = notes_in(folder / ".mien/partial/frames/a/k");
  std::string text = read_file(notes);
  const std::size_t name = text.find("1.png");
  text.replace(name, 5, "3.png");
  write_file(notes, text);
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 5);
  EXPECT_EQ(published().at("3.png"), "k3.png");
}

TEST_F(FrameStoreTest, TwoProcessesShareOneSequence) {
  Store here(folder);
  Store there(folder);
  const auto mine = here.frames("frames/a", "k");
  const auto theirs = there.frames("frames/a", "k");
  const auto draw = [](FrameStore& frames, const std::string& name) {
    frames.put(
        name, [&](const fs::path& file) { write_file(file, "k" + name); }, [](const fs::path&) {});
  };
  draw(*mine, "0.png");
  draw(*theirs, "1.png");
  draw(*mine, "2.png");
  draw(*theirs, "3.png");
  for (const std::string& name : names) {
    EXPECT_TRUE(mine->find(name)) << name;
    EXPECT_TRUE(theirs->find(name)) << name;
  }
  const Receipt first = mine->publish(names);
  const Receipt second = theirs->publish(names);
  EXPECT_EQ(first.hash, second.hash);
  EXPECT_TRUE(here.find("frames/a", "k"));
  EXPECT_EQ(published().size(), 4u);
  EXPECT_TRUE(here.nondeterminism().empty());
  EXPECT_TRUE(there.nondeterminism().empty());
}

TEST_F(FrameStoreTest, AFrameThatComesTooLateHarmsNothing) {
  Store here(folder);
  Store there(folder);
  const auto late = there.frames("frames/a", "k");
  const auto draw = [](const fs::path& file) { write_file(file, "k0.png"); };
  late->put("0.png", draw, [&](const fs::path&) { film(here, "k"); });
  EXPECT_TRUE(here.find("frames/a", "k"));
  EXPECT_TRUE(there.nondeterminism().empty());
}

TEST_F(FrameStoreTest, TellsWhoDrewAFrameOtherwise) {
  Store here(folder);
  Store there(folder);
  const auto put = [](Store& store, const std::string& text) {
    store.frames("frames/a", "k")
        ->put(
            "0.png", [&](const fs::path& file) { write_file(file, text); }, [](const fs::path&) {});
  };
  put(here, "one");
  put(there, "another");
  ASSERT_EQ(there.nondeterminism().size(), 1u);
  EXPECT_EQ(there.nondeterminism()[0].before, hash_of("one"));
  EXPECT_FALSE(there.nondeterminism()[0].before_by.host.empty());
}

TEST_F(FrameStoreTest, MendsAPublishedSequenceFrameByFrame) {
  Store store(folder);
  film(store, "k");
  write_file(folder / "frames/a/2.png", "damaged");
  EXPECT_FALSE(store.find("frames/a", "k"));
  film(store, "k");
  EXPECT_EQ(drawn, 5);
  EXPECT_EQ(published().at("2.png"), "k2.png");
  EXPECT_TRUE(store.find("frames/a", "k"));
}

TEST_F(FrameStoreTest, AFrameTooManyIsNotTheSequence) {
  Store store(folder);
  film(store, "k");
  write_file(folder / "frames/a/9.png", "stray");
  EXPECT_FALSE(store.find("frames/a", "k"));
  film(store, "k");
  EXPECT_EQ(drawn, 4);
  EXPECT_EQ(published().size(), 4u);
  EXPECT_EQ(set_aside(), (std::map<std::string, std::string>{{"9.png", "stray"}}));
}

TEST_F(FrameStoreTest, SetsAsideWhatAUserPutBesideTheFramesOfAFilm) {
  Store store(folder);
  film(store, "k");
  write_file(folder / "frames/a/notes.txt", "of the user");
  fs::create_directories(folder / "frames/a/selection");
  write_file(folder / "frames/a/selection/best.png", "chosen");
  film(store, "q");
  EXPECT_EQ(published().size(), names.size());
  EXPECT_EQ(set_aside(), (std::map<std::string, std::string>{{"best.png", "chosen"},
                                                             {"notes.txt", "of the user"}}));
  ASSERT_EQ(store.repairs().size(), 1u);
  EXPECT_TRUE(store.repairs()[0].starts_with("frames/a: ")) << store.repairs()[0];
  EXPECT_NE(store.repairs()[0].find("notes.txt"), std::string::npos) << store.repairs()[0];
  // The frames that a shorter film lacks are not the user's.
  const auto shorter = store.frames("frames/a", "s");
  shorter->put(
      "0.png", [](const fs::path& file) { write_file(file, "s0.png"); }, [](const fs::path&) {});
  shorter->publish({"0.png"});
  EXPECT_EQ(published().size(), 1u);
  EXPECT_EQ(set_aside().size(), 2u);
}

TEST_F(FrameStoreTest, HiddenFilesDoNotMakeASequenceAnother) {
  Store store(folder);
  film(store, "k");
  write_file(folder / "frames/a/.DS_Store", "of a file browser");
  EXPECT_TRUE(store.find("frames/a", "k"));
  film(store, "k");
  EXPECT_EQ(drawn, 4);
}

TEST_F(FrameStoreTest, AnotherKeyBeginsAnew) {
  Store store(folder);
  film(store, "k", 2);
  film(store, "q");
  EXPECT_EQ(drawn, 6);
  EXPECT_EQ(published().at("0.png"), "q0.png");
  EXPECT_FALSE(store.find("frames/a", "k"));
}

TEST_F(FrameStoreTest, KeepsTheOldSequenceUntilTheNewOneIsWhole) {
  Store store(folder);
  film(store, "k");
  film(store, "q", 3);
  EXPECT_EQ(published().at("0.png"), "k0.png");
  EXPECT_TRUE(store.find("frames/a", "k"));
}

TEST_F(FrameStoreTest, LosesNoFrameWhenKilledBetweenPublishingAndReceipt) {
  {
    Store store(folder);
    film(store, "k", 3);
  }
  // What publish() does before the receipt: the frames have second names in their place.
  fs::create_directories(folder / "frames/a");
  for (const auto& entry : fs::directory_iterator(folder / ".mien/partial/frames/a/k/frames"))
    fs::create_hard_link(entry.path(), folder / "frames/a" / entry.path().filename());
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 4);
  EXPECT_TRUE(store.find("frames/a", "k"));
}

TEST_F(FrameStoreTest, PublishesNoFrameThatWasChangedSinceItWasFound) {
  Store store(folder);
  const auto frames = store.frames("frames/a", "k");
  const auto accept = [](const fs::path&) {};
  const fs::path file = frames->put(
      "0.png", [](const fs::path& at) { write_file(at, "frame"); }, accept);
  write_file(file, "other");
  EXPECT_THROW(frames->publish({"0.png"}), WriteFailure);
  EXPECT_FALSE(fs::exists(folder / "frames/a"));
  EXPECT_FALSE(frames->find("0.png"));
}

TEST_F(FrameStoreTest, ASequenceIsThereAtEveryMomentWhileAnotherTakesItsPlace) {
  Store store(folder);
  const fs::path one = temporary.path() / "one";
  const fs::path other = temporary.path() / "other";
  make_folder(one);
  make_folder(other);
  if (::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) != 0)
    GTEST_SKIP() << "folders cannot change places here";
  film(store, "k");
  std::atomic<bool> is_over = false;
  std::atomic<int> looks = 0;
  std::thread reader([&] {
    for (; !is_over; ++looks) EXPECT_TRUE(fs::exists(folder / "frames/a/0.png"));
  });
  for (int times = 0; times < 40 || looks < 100; ++times) film(store, "k" + std::to_string(times));
  is_over = true;
  reader.join();
}

TEST_F(FrameStoreTest, ReportsAFrameThatCameOutOtherwise) {
  Store store(folder);
  film(store, "k");
  write_file(folder / "frames/a/2.png", "damaged");
  const auto frames = store.frames("frames/a", "k");
  frames->put(
      "2.png", [](const fs::path& file) { write_file(file, "other"); }, [](const fs::path&) {});
  ASSERT_EQ(store.nondeterminism().size(), 1u);
  EXPECT_EQ(store.nondeterminism()[0].path, "frames/a/2.png");
}

}  // namespace
}  // namespace mien::pipeline
