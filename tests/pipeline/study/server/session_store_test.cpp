#include "pipeline/study/server/session_store.h"

#include <csignal>
#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/study/server/full_disk.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

using test::TemporaryFolder;

StoredRecord trial(int session, int number, const std::string& content = "{}") {
  return {.session = session,
          .position = number - 1,
          .name = "trial-" + std::to_string(number),
          .content = content,
          .stored_at = "2026-01-01T00:00:00Z"};
}

void begin_two(SessionStore& store) {
  store.begin({{"design", "abc"}}, {{.index = 0, .participant = "p001", .link = "one"},
                                    {.index = 1, .participant = "p002", .link = "two"}});
}

TEST(SessionStore, KeepsWhatItIsGivenOnceAndInOrder) {
  const TemporaryFolder folder;
  SessionStore store(folder.path() / "answers.db");
  begin_two(store);
  EXPECT_EQ(store.keep(trial(0, 2)), RecordOutcome::out_of_order);
  EXPECT_EQ(store.keep(trial(0, 1, "a")), RecordOutcome::stored);
  EXPECT_EQ(store.keep(trial(0, 1, "a")), RecordOutcome::same);
  EXPECT_EQ(store.keep(trial(0, 1, "b")), RecordOutcome::other);
  EXPECT_EQ(store.keep(trial(1, 1, "b")), RecordOutcome::stored);
  EXPECT_EQ(store.keep(trial(0, 2, "'; DROP TABLE records; --")), RecordOutcome::stored);
  const std::vector<StoredRecord> records = store.records_of(0);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].content, "a");
  EXPECT_EQ(records[1].content, "'; DROP TABLE records; --");
  EXPECT_EQ(store.records().size(), 3u);
}

TEST(SessionStore, KeepsHowASessionEnded) {
  const TemporaryFolder folder;
  {
    SessionStore store(folder.path() / "answers.db");
    begin_two(store);
    EXPECT_EQ(store.keep(trial(1, 1, "a"), "screened_out"), RecordOutcome::stored);
    EXPECT_EQ(store.keep(trial(1, 1, "a"), "screened_out"), RecordOutcome::same);
    EXPECT_EQ(store.keep(trial(0, 2, "a"), "screened_out"), RecordOutcome::out_of_order);
  }
  SessionStore store(folder.path() / "answers.db");
  EXPECT_EQ(store.sessions().at(0).ended, "");
  EXPECT_EQ(store.sessions().at(1).ended, "screened_out");
}

/// Whether a file or its write-ahead log holds the text.
bool holds(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path log = file.string() + "-wal";
  return read_file(file).find(text) != std::string::npos ||
         (exists(log) && read_file(log).find(text) != std::string::npos);
}

TEST(SessionStore, OverwritesWhatIsErased) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "answers.db";
  const std::string secret = "the answer of somebody who withdraws";
  const std::string longer(20'000, 'x');
  SessionStore store(file);
  begin_two(store);
  for (int number = 1; number < 30; ++number) {
    store.keep(trial(0, number, secret + std::to_string(number) + longer));
    store.keep(trial(1, number, "of another" + std::to_string(number) + longer));
  }
  store.mark_begun(0, "join", "2026-05-05T00:00:00Z");
  ASSERT_TRUE(holds(file, secret));
  EXPECT_EQ(store.erase_records(0, "withdrawn"), 29);
  EXPECT_FALSE(holds(file, secret));
  EXPECT_FALSE(holds(file, "2026-05-05"));
  EXPECT_TRUE(holds(file, "of another29"));
  EXPECT_TRUE(store.records_of(0).empty());
  EXPECT_EQ(store.records_of(1).size(), 29u);
  EXPECT_EQ(store.sessions().at(0).ended, "withdrawn");
  EXPECT_EQ(store.erase_records(0, "withdrawn"), 0);
}

TEST(SessionStore, OverwritesLaterWhatIsErasedOnAFullDisk) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "answers.db";
  const std::string secret = "the answer of somebody who withdraws";
  {
    SessionStore store(file);
    begin_two(store);
    for (int number = 1; number <= 200; ++number)
      store.keep(trial(0, number, std::string(2'000, 'x')));
    store.keep(trial(1, 1, secret));  // in the last pages
  }
  SessionStore store(file);
  {
    const FullDisk full(100'000);  // there is space in the log, not in the file behind it
    EXPECT_EQ(store.erase_records(1, "withdrawn"), 1);
    EXPECT_TRUE(store.has_erased_log());
    EXPECT_TRUE(store.records_of(1).empty());
  }
  EXPECT_TRUE(holds(file, secret));
  EXPECT_EQ(store.keep(trial(0, 201)), RecordOutcome::stored);
  EXPECT_FALSE(store.has_erased_log());
  EXPECT_FALSE(holds(file, secret));
}

/// Makes a file with the tables of version 1, which had no ends of sessions.
void make_first_version(const std::filesystem::path& file) {
  Database database(file);
  database.run(R"(
    CREATE TABLE facts(name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT, WITHOUT ROWID;
    CREATE TABLE sessions(number INTEGER PRIMARY KEY, plan INTEGER NOT NULL,
      participant TEXT NOT NULL UNIQUE, link TEXT NOT NULL UNIQUE,
      begun_at TEXT NOT NULL DEFAULT '', came_by TEXT NOT NULL DEFAULT '') STRICT;
    CREATE TABLE records(session INTEGER NOT NULL REFERENCES sessions(number),
      position INTEGER NOT NULL, name TEXT NOT NULL, content TEXT NOT NULL,
      kept_at TEXT NOT NULL, PRIMARY KEY(session, position), UNIQUE(session, name))
      STRICT, WITHOUT ROWID;
    INSERT INTO sessions(number, plan, participant, link) VALUES(0, 0, 'p001', 'one');
    INSERT INTO records VALUES(0, 0, 'consent', '{}', 'then');
    PRAGMA application_id = 1835623790;
    PRAGMA user_version = 1;)");
}

TEST(SessionStore, ConvertsFilesOfTheFirstVersion) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "answers.db";
  make_first_version(file);
  for (int opened = 0; opened < 2; ++opened) {
    SessionStore store(file);
    EXPECT_EQ(store.records().size(), 1u);
    EXPECT_EQ(store.sessions().at(0).link, "one");
    EXPECT_EQ(store.sessions().at(0).ended, "");
  }
}

TEST(SessionStore, IsReadWithoutConversion) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "answers.db";
  make_first_version(file);
  const std::string before = read_file(file);
  {
    SessionStore store(file, DatabaseUse::read);
    ASSERT_EQ(store.sessions().size(), 1u);
    EXPECT_EQ(store.sessions()[0].participant, "p001");
    EXPECT_EQ(store.sessions()[0].ended, "");
    EXPECT_EQ(store.records_of(0).size(), 1u);
    EXPECT_THROW(SessionStore(file, DatabaseUse::read), Error) << "it is locked";
  }
  EXPECT_EQ(read_file(file), before);
  EXPECT_FALSE(exists(folder.path() / "answers.db-wal"));
}

TEST(SessionStore, IsReadWithTheLogOfAKilledServerWhichStays) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "answers.db", copy = folder.path() / "killed.db";
  const fs::path log = copy.string() + "-wal";
  {
    SessionStore store(file);
    begin_two(store);
    store.keep(trial(1, 1, "in the log"));
    fs::copy_file(file, copy);
    fs::copy_file(file.string() + "-wal", log);
  }
  const std::string before = read_file(copy), log_before = read_file(log);
  EXPECT_EQ(SessionStore(copy, DatabaseUse::read).records_of(1).at(0).content, "in the log");
  EXPECT_EQ(read_file(copy), before);
  EXPECT_EQ(read_file(log), log_before);
  EXPECT_EQ(SessionStore(copy).records().size(), 1u);
}

TEST(SessionStore, ReadsFilesOfOthersWithoutChange) {
  const TemporaryFolder folder;
  const std::filesystem::path empty = folder.path() / "empty.db";
  std::ofstream(empty).flush();
  EXPECT_TRUE(SessionStore(empty, DatabaseUse::read).sessions().empty());
  EXPECT_EQ(read_file(empty), "");
  const std::filesystem::path other = folder.path() / "other.db";
  {
    Database database(other);
    database.run("PRAGMA journal_mode = DELETE; CREATE TABLE birds(name TEXT)");
  }
  const std::string before = read_file(other);
  EXPECT_THROW(SessionStore(other, DatabaseUse::read), Error);
  EXPECT_EQ(read_file(other), before);
}

TEST(SessionStore, IsThereAgainWithAllThatWasKept) {
  const TemporaryFolder folder;
  {
    SessionStore store(folder.path() / "answers.db");
    begin_two(store);
    store.keep(trial(1, 1, "kept"));
    EXPECT_TRUE(store.mark_begun(1, "join", "now"));
    EXPECT_FALSE(store.mark_begun(1, "link", "later"));
  }
  SessionStore store(folder.path() / "answers.db");
  EXPECT_EQ(store.fact("design"), "abc");
  EXPECT_EQ(store.fact("else"), std::nullopt);
  EXPECT_EQ(store.records_of(1).at(0).content, "kept");
  EXPECT_EQ(store.sessions().at(1).entry_route, "join");
  EXPECT_EQ(store.sessions().at(1).begun_at, "now");
}

/// Tells each number over the pipe as soon as it is stored, until it is killed.
[[noreturn]] void keep_until_killed(const std::filesystem::path& file, int first, int pipe_end) {
  SessionStore store(file);
  for (int number = first;; ++number) {
    if (store.keep(trial(0, number, std::to_string(number))) != RecordOutcome::stored) _exit(1);
    if (write(pipe_end, &number, sizeof number) != sizeof number) _exit(2);
  }
}

TEST(SessionStore, LosesNothingWhenItsProcessIsKilled) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "answers.db";
  {
    SessionStore store(file);
    begin_two(store);
  }
  int told = 0;
  for (int round = 0; round < 5; ++round) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    std::size_t stored = SessionStore(file).records().size();
    ASSERT_GE(stored, static_cast<std::size_t>(told));
    const pid_t child = fork();
    if (child == 0) keep_until_killed(file, static_cast<int>(stored) + 1, ends[1]);
    close(ends[1]);
    for (int count = 0; count < 20 + 7 * round; ++count)
      ASSERT_EQ(read(ends[0], &told, sizeof told), static_cast<ssize_t>(sizeof told));
    kill(child, SIGKILL);
    while (read(ends[0], &told, sizeof told) == static_cast<ssize_t>(sizeof told)) {
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  const std::vector<StoredRecord> records = SessionStore(file).records();
  ASSERT_GE(records.size(), static_cast<std::size_t>(told));
  ASSERT_LE(records.size(), static_cast<std::size_t>(told) + 1);  // stored, but not told any more
  for (std::size_t at = 0; at < records.size(); ++at)
    EXPECT_EQ(records[at].content, std::to_string(at + 1));
}

TEST(SessionStore, IsOfOneProcessAtATime) {
  const TemporaryFolder folder;
  const SessionStore store(folder.path() / "answers.db");
  try {
    const SessionStore second(folder.path() / "answers.db");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("another process has it open"), std::string::npos)
        << error.what();
  }
}

/// What opening a file throws; "" nothing.
std::string refusal_of(const std::filesystem::path& file) {
  try {
    const SessionStore store(file);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SessionStore, RefusesACopyThatLacksTheLogOfAServerThatRan) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "answers.db";
  for (const std::string name : {"new.db", "again.db"}) {
    const fs::path copy = folder.path() / name, log = copy.string() + "-wal";
    SessionStore store(file);
    if (store.sessions().empty()) begin_two(store);
    store.keep(trial(0, name == "new.db" ? 1 : 2));
    fs::copy_file(file, copy);
    const std::string said = refusal_of(copy);
    EXPECT_NE(said.find(log.string()), std::string::npos) << said;
    EXPECT_NE(said.find("stop the server"), std::string::npos) << said;
    fs::remove(log);
    fs::copy_file(file, copy, fs::copy_options::overwrite_existing);
    fs::copy_file(file.string() + "-wal", log);
    EXPECT_EQ(SessionStore(copy).records().size(), store.records().size());
    EXPECT_EQ(refusal_of(copy), "");  // it was ended, and needs no log
  }
  fs::copy_file(file, folder.path() / "ended.db");
  EXPECT_EQ(SessionStore(folder.path() / "ended.db").records().size(), 2u);
}

TEST(SessionStore, RefusesFilesOfAnotherKind) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "notes.txt") << std::string(5000, 'x');
  EXPECT_THROW(SessionStore(folder.path() / "notes.txt"), Error);
  EXPECT_EQ(read_file(folder.path() / "notes.txt"), std::string(5000, 'x'));
  {
    Database other(folder.path() / "other.db");
    other.run("CREATE TABLE birds(name TEXT)");
  }
  EXPECT_THROW(SessionStore(folder.path() / "other.db"), Error);
  {
    SessionStore(folder.path() / "later.db");
    Database later(folder.path() / "later.db");
    later.run("PRAGMA user_version = 3");
  }
  EXPECT_THROW(SessionStore(folder.path() / "later.db"), Error);
  std::filesystem::create_symlink(folder.path() / "elsewhere.db", folder.path() / "link.db");
  EXPECT_THROW(SessionStore(folder.path() / "link.db"), Error);
  EXPECT_THROW(SessionStore(folder.path() / "no" / "folder.db"), Error);
}

TEST(SessionStore, SaysThatADiskIsFullKeepsNothingOfItAndGoesOnWhenThereIsRoom) {
  const TemporaryFolder folder;
  SessionStore store(folder.path() / "answers.db");
  begin_two(store);
  ASSERT_EQ(store.keep(trial(0, 1)), RecordOutcome::stored);
  {
    const FullDisk full(4096);
    EXPECT_THROW(store.keep(trial(0, 2, std::string(50'000, 'x'))), WriteFailure);
    EXPECT_THROW(store.keep(trial(0, 2, std::string(50'000, 'x'))), WriteFailure);
    EXPECT_EQ(store.records().size(), 1u);
  }
  EXPECT_EQ(store.keep(trial(0, 2, std::string(50'000, 'x'))), RecordOutcome::stored);
  EXPECT_EQ(store.records().size(), 2u);
}

TEST(RandomLink, Has128BitsThatDiffer) {
  std::set<std::string> links;
  for (int count = 0; count < 1000; ++count) links.insert(random_link());
  EXPECT_EQ(links.size(), 1000u);
  EXPECT_EQ(links.begin()->size(), 32u);
  EXPECT_EQ(links.begin()->find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
