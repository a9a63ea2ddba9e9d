#include "pipeline/tasks/store.h"

#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/disk_fault.h"
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

  /// Files below this process' folder of attempts: what a finished attempt must not leave.
  int attempts_left() const {
    const fs::path attempts = folder / ".mien" / "attempts";
    return fs::exists(attempts)
               ? static_cast<int>(std::distance(fs::recursive_directory_iterator(attempts), {})) - 1
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

TEST_F(StoreTest, OfTwoAttemptsThatDifferTheFirstStaysAndBothAreReported) {
  Store store(folder);
  put(store, "a", "key1", "one");
  put(store, "a", "key1", "one");
  put(store, "a", "key2", "two");
  EXPECT_TRUE(store.nondeterminism().empty());
  EXPECT_EQ(put(store, "a", "key2", "three").hash, hash_of("two"));
  EXPECT_EQ(read_file(folder / "a"), "two");
  ASSERT_EQ(store.nondeterminism().size(), 1u);
  const Nondeterminism met = store.nondeterminism()[0];
  EXPECT_EQ(met.path, "a");
  EXPECT_EQ(met.before, hash_of("two"));
  EXPECT_EQ(met.now, hash_of("three"));
  EXPECT_FALSE(met.before_by.host.empty());
  EXPECT_FALSE(met.before_by.instruction_set.empty());
  EXPECT_EQ(met.before_by, met.now_by);
}

TEST_F(StoreTest, ADamagedArtifactMadeAgainIsNoNondeterminism) {
  Store store(folder);
  put(store, "a", "key1", "one");
  write_file(folder / "a", "two");
  put(store, "a", "key1", "one");
  EXPECT_TRUE(store.nondeterminism().empty());
  EXPECT_TRUE(store.find("a", "key1"));
}

TEST_F(StoreTest, ManyMayWriteUnlessOneWantsItToItself) {
  {
    const Store first(folder);
    EXPECT_NO_THROW(Store(folder, Sharing::shared));
    EXPECT_THROW(Store(folder, Sharing::exclusive), StoreBusy);
  }
  {
    const Store alone(folder, Sharing::exclusive);
    EXPECT_THROW(Store(folder, Sharing::shared), StoreBusy);
    EXPECT_THROW(Store(folder, Sharing::exclusive), StoreBusy);
  }
  EXPECT_NO_THROW(Store(folder, Sharing::exclusive));
}

TEST_F(StoreTest, RemovesWhatKilledAttemptsLeftAndNothingOfTheLiving) {
  const fs::path attempts = folder / ".mien/attempts";
  fs::create_directories(attempts / "nobody-1");
  write_file(attempts / "nobody-1/a.mp4", "half");
  Store living(folder);
  fs::path seen;
  const auto look = [&](const fs::path& file) {
    const Store second(folder);
    seen = file;
    EXPECT_TRUE(fs::exists(file));
    EXPECT_FALSE(fs::exists(attempts / "nobody-1"));
  };
  living.put("a", "k", writing("x"), look);
  EXPECT_FALSE(seen.empty());
}

/// A record of a process that is not there any more.
WorkerRecord of_the_dead() {
  WorkerRecord record = record_of_this_process();
  record.process_start += "1";
  return record;
}

TEST_F(StoreTest, AProcessWithTheNumberOfADeadOneIsAnother) {
  const WorkerRecord dead = of_the_dead();
  EXPECT_TRUE(is_gone(dead));
  EXPECT_FALSE(is_gone(record_of_this_process()));
  fs::create_directories(folder / ".mien/attempts" / dead.name);
  fs::create_directories(worker_record_path(folder, dead.name).parent_path());
  write_file(worker_record_path(folder, dead.name), to_json(dead));
  const Store store(folder, Sharing::exclusive);
  EXPECT_FALSE(fs::exists(folder / ".mien/attempts" / dead.name));
  EXPECT_FALSE(read_worker_record(folder, dead.name));
}

TEST_F(StoreTest, NothingIsProvenOfAnotherMachinesProcesses) {
  WorkerRecord other = of_the_dead();
  other.boot = "another boot";
  EXPECT_FALSE(is_gone(other));
  fs::create_directories(folder / ".mien/attempts" / other.name);
  fs::create_directories(worker_record_path(folder, other.name).parent_path());
  write_file(worker_record_path(folder, other.name), to_json(other));
  const Store store(folder);
  EXPECT_TRUE(fs::exists(folder / ".mien/attempts" / other.name));
  EXPECT_THROW(Store(folder, Sharing::exclusive), StoreBusy);
  other.ended = true;
  write_file(worker_record_path(folder, other.name), to_json(other));
  EXPECT_TRUE(is_gone(other));
}

TEST_F(StoreTest, AClaimIsHeldByOneAtATimeAndOutlivesNobody) {
  Store first(folder);
  Store second(folder);
  auto claim = first.claim("film:a");
  EXPECT_TRUE(claim);
  EXPECT_FALSE(second.claim("film:a"));
  EXPECT_TRUE(second.claim("film:b"));
  claim.reset();
  EXPECT_TRUE(second.claim("film:a"));

  write_file(folder / ".mien/claims" / hash_of("film:c"), "nobody-1\n");
  EXPECT_TRUE(first.claim("film:c"));
}

TEST_F(StoreTest, AClaimThatIsNoFileOrOnesOwnIsTakenOver) {
  Store store(folder);
  const fs::path file = folder / ".mien/claims" / hash_of("film:a");
  fs::create_directories(file / "inside");
  EXPECT_TRUE(store.claim("film:a"));
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_TRUE(store.claim("film:a"));
  write_file(file, store.heartbeat().self().name + "\n");
  EXPECT_TRUE(store.claim("film:a")) << "nobody else would ever give it back";
}

TEST_F(StoreTest, AnAttemptWhoseFolderWasClearedAwayMayBeTriedAgain) {
  Store store(folder);
  const auto fail = [&](const fs::path& file) {
    fs::remove_all(file.parent_path());
    throw std::runtime_error("no such file");
  };
  EXPECT_THROW(store.put("a", "k", fail, accept), WriteFailure);
  EXPECT_THROW(
      store.put(
          "a", "k", [](const fs::path&) { throw std::runtime_error("no picture"); }, accept),
      std::runtime_error);
  EXPECT_EQ(attempts_left(), 0);
}

TEST_F(StoreTest, AFolderThatIsAwayIsNotMadeAnew) {
  const fs::path away = folder.string() + "-away";
  {
    Store store(folder);
    put(store, "a", "k", "text");
    fs::rename(folder, away);
    EXPECT_THROW(put(store, "b", "k", "text"), DiskFault);
    EXPECT_FALSE(fs::exists(folder));
    fs::rename(away, folder);
    put(store, "b", "k", "text");
  }
  EXPECT_EQ(read_file(folder / "b"), "text");
}

TEST_F(StoreTest, AnAttemptThatWasOvertakenIsDropped) {
  Store slow(folder);
  Store fast(folder);
  const auto overtaken = [&](const fs::path&) { put(fast, "a", "k", "text"); };
  const Receipt receipt = slow.put("a", "k", writing("text"), overtaken);
  EXPECT_EQ(receipt.hash, hash_of("text"));
  EXPECT_TRUE(slow.nondeterminism().empty());
  EXPECT_TRUE(fast.find("a", "k"));
}

TEST_F(StoreTest, ADamagedReceiptIsNoReceiptAndNoNondeterminism) {
  Store store(folder);
  put(store, "a", "k", "text");
  const fs::path file = receipt_path(folder, "a");
  const std::string whole = read_file(file);
  for (const char* field : {"\"hash\": \"", "\"key\": \"", "\"host\": \"", "\"size\": "}) {
    std::string text = whole;
    char& digit = text[text.find(field) + std::string(field).size()];
    digit = digit == '1' ? '2' : '1';
    write_file(file, text);
    EXPECT_FALSE(read_receipt(folder, "a")) << text;
    put(store, "a", "k", "text");
    EXPECT_EQ(read_file(file), whole);
  }
  EXPECT_TRUE(store.nondeterminism().empty());
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

/// What may lie where an artifact, its folder or its receipt has to be.
class ObstacleTest : public StoreTest, public testing::WithParamInterface<std::string> {
 protected:
  static void put_obstacle(const std::string& kind, const fs::path& at) {
    fs::create_directories(at.parent_path());
    fs::remove_all(at);
    if (kind == "folder") fs::create_directories(at / "of the user");
    if (kind == "loop") fs::create_symlink(at.filename(), at);
    if (kind == "dangling link") fs::create_symlink("nowhere", at);
    if (kind == "fifo") {
      EXPECT_EQ(::mkfifo(at.c_str(), 0666), 0);
    }
  }
};

TEST_P(ObstacleTest, IsSetAsideAndTold) {
  for (const fs::path& place : {folder / "videos/a.mp4", receipt_path(folder, "videos/a.mp4")}) {
    Store store(folder);
    put_obstacle(GetParam(), place);
    EXPECT_FALSE(store.find("videos/a.mp4", "k"));
    put(store, "videos/a.mp4", "k", "text");
    EXPECT_TRUE(store.find("videos/a.mp4", "k"));
    ASSERT_EQ(store.repairs().size(), 1u);
    EXPECT_NE(store.repairs()[0].find(".mien/set-aside/"), std::string::npos);
    if (GetParam() != "folder") continue;
    bool is_kept = false;
    for (const auto& entry : fs::recursive_directory_iterator(folder / ".mien/set-aside"))
      is_kept = is_kept || entry.path().filename() == "of the user";
    EXPECT_TRUE(is_kept);
  }
}

TEST_P(ObstacleTest, InTheFoldersPlaceIsSetAsideUnlessItIsAFolder) {
  Store store(folder);
  put_obstacle(GetParam(), folder / "videos");
  put(store, "videos/a.mp4", "k", "text");
  EXPECT_TRUE(store.find("videos/a.mp4", "k"));
  EXPECT_EQ(store.repairs().size(), GetParam() == "folder" ? 0u : 1u);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ObstacleTest,
                         testing::Values("folder", "loop", "dangling link", "fifo"),
                         [](const auto& kind) {
                           std::string name = kind.param;
                           std::erase(name, ' ');
                           return name;
                         });

}  // namespace
}  // namespace mien::pipeline
