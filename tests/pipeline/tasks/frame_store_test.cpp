#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/documents/files.h"
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
  write_file(folder / ".mien/partial/frames/a/1.png", "damaged");
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 5);
  EXPECT_EQ(published().at("1.png"), "k1.png");
  EXPECT_TRUE(store.nondeterminism().empty());
}

TEST_F(FrameStoreTest, ReadsAJournalUpToWhereItWasCutOff) {
  {
    Store store(folder);
    film(store, "k", 3);
  }
  const fs::path journal = folder / ".mien/partial/frames/a.journal";
  const std::string text = read_file(journal);
  write_file(journal, text.substr(0, text.size() - 20));
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 5);
  EXPECT_TRUE(store.find("frames/a", "k"));
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
  // What publish() does before the receipt: the frames move to their place, the journal stays.
  fs::create_directories(folder / "frames");
  fs::rename(folder / ".mien/partial/frames/a", folder / "frames/a");
  Store store(folder);
  film(store, "k");
  EXPECT_EQ(drawn, 4);
  EXPECT_TRUE(store.find("frames/a", "k"));
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
