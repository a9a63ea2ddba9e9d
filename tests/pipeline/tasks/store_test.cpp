#include "pipeline/tasks/store.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "pipeline/documents/files.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class StoreTest : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "study";

  static Store::Write writing(const std::string& text) {
    return [text](const fs::path& file) { write_file(file, text); };
  }
  static void accept(const fs::path&) {}

  static Receipt put(Store& store, const std::string& path, const Hash& key,
                     const std::string& text) {
    return store.put(path, key, writing(text), accept);
  }

  /// Files below the attempts' folder: what a finished run must not leave.
  int attempts_left() const {
    const fs::path attempts = folder / ".mien" / "attempts";
    return fs::exists(attempts)
               ? static_cast<int>(std::distance(fs::directory_iterator(attempts), {}))
               : 0;
  }
};

TEST_F(StoreTest, FindsWhatItPutUnderItsKeyOnly) {
  Store store(folder);
  const Receipt receipt = put(store, "clips/a.bvh", "key1", "motion");
  EXPECT_EQ(receipt.hash, hash_of("motion"));
  EXPECT_EQ(receipt.size, 6u);
  EXPECT_EQ(read_file(folder / "clips/a.bvh"), "motion");
  ASSERT_TRUE(store.find("clips/a.bvh", "key1"));
  EXPECT_FALSE(store.find("clips/a.bvh", "key2"));
  EXPECT_FALSE(store.find("clips/b.bvh", "key1"));
  EXPECT_EQ(attempts_left(), 0);
}

TEST_F(StoreTest, TrustsNothingBecauseItExists) {
  fs::create_directories(folder / "clips");
  write_file(folder / "clips/a.bvh", "motion");
  Store store(folder);
  EXPECT_FALSE(store.find("clips/a.bvh", "key1"));
  put(store, "clips/a.bvh", "key1", "motion");
  write_file(folder / "clips/a.bvh", "notion");
  EXPECT_FALSE(store.find("clips/a.bvh", "key1"));
  write_file(folder / "clips/a.bvh", "motion");
  EXPECT_TRUE(store.find("clips/a.bvh", "key1"));
  fs::remove(folder / "clips/a.bvh");
  EXPECT_FALSE(store.find("clips/a.bvh", "key1"));
  put(store, "clips/a.bvh", "key1", "motion");
  write_file(receipt_path(folder, "clips/a.bvh"), "{\"key\": \"key1\"");
  EXPECT_FALSE(store.find("clips/a.bvh", "key1"));
}

TEST_F(StoreTest, AReceiptOfAnotherArtifactIsNoReceipt) {
  Store store(folder);
  put(store, "a", "key1", "same");
  put(store, "b", "key2", "same");
  fs::copy_file(receipt_path(folder, "a"), receipt_path(folder, "b"),
                fs::copy_options::overwrite_existing);
  EXPECT_FALSE(store.find("b", "key1"));
}

TEST_F(StoreTest, PublishesNothingThatFailsToWriteOrVerify) {
  Store store(folder);
  put(store, "a", "key1", "old");
  const auto broken = [](const fs::path&) { throw std::runtime_error("does not decode"); };
  EXPECT_THROW(store.put("a", "key2", writing("new"), broken), std::runtime_error);
  EXPECT_THROW(store.put("a", "key2", broken, accept), std::runtime_error);
  EXPECT_THROW(store.put("a", "key2", accept, accept), std::system_error);
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_TRUE(store.find("a", "key1"));
}

TEST_F(StoreTest, VerifiesTheFileBeforeItIsPublished) {
  Store store(folder);
  fs::path seen;
  store.put("videos/a.mp4", "k", writing("x"), [&](const fs::path& file) {
    seen = file;
    EXPECT_FALSE(fs::exists(folder / "videos/a.mp4"));
  });
  EXPECT_EQ(seen.filename(), "a.mp4");
  EXPECT_NE(seen.parent_path(), folder / "videos");
}

TEST_F(StoreTest, ReportsOtherBytesUnderTheSameKey) {
  Store store(folder);
  put(store, "a", "key1", "one");
  put(store, "a", "key1", "one");
  put(store, "a", "key2", "two");
  EXPECT_TRUE(store.nondeterminism().empty());
  put(store, "a", "key2", "three");
  ASSERT_EQ(store.nondeterminism().size(), 1u);
  EXPECT_EQ(store.nondeterminism()[0].path, "a");
  EXPECT_EQ(store.nondeterminism()[0].before, hash_of("two"));
  EXPECT_EQ(store.nondeterminism()[0].now, hash_of("three"));
}

TEST_F(StoreTest, ADamagedArtifactMadeAgainIsNoNondeterminism) {
  Store store(folder);
  put(store, "a", "key1", "one");
  write_file(folder / "a", "two");
  put(store, "a", "key1", "one");
  EXPECT_TRUE(store.nondeterminism().empty());
  EXPECT_TRUE(store.find("a", "key1"));
}

TEST_F(StoreTest, IsForOneRunAtATime) {
  {
    const Store first(folder);
    EXPECT_THROW(Store second(folder), StoreBusy);
  }
  EXPECT_NO_THROW(Store third(folder));
}

TEST_F(StoreTest, RemovesWhatKilledAttemptsLeft) {
  fs::create_directories(folder / ".mien/attempts/123-1");
  write_file(folder / ".mien/attempts/123-1/a.mp4", "half");
  const Store store(folder);
  EXPECT_EQ(attempts_left(), 0);
}

TEST_F(StoreTest, ReplacesAFolderByAFileAndAFileByAFolder) {
  Store store(folder);
  fs::create_directories(folder / "a/b");
  put(store, "a", "k", "text");
  EXPECT_EQ(read_file(folder / "a"), "text");
  auto frames = store.frames("a", "k2");
  frames->put("0.png", writing("f"), accept);
  frames->publish({"0.png"});
  EXPECT_EQ(read_file(folder / "a/0.png"), "f");
}

}  // namespace
}  // namespace mien::pipeline
