#include "pipeline/study/server/session_store.h"

#include <array>
#include <stdexcept>
#include <string>

#include <sys/random.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

/// application_id ("mien") and user_version, the version of the tables below.
constexpr std::int64_t store_application_id = 0x6d69656e;
constexpr std::int64_t store_version = 2;

constexpr const char* store_tables = R"(
CREATE TABLE facts(name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE sessions(
  number INTEGER PRIMARY KEY,
  plan INTEGER NOT NULL,
  participant TEXT NOT NULL UNIQUE,
  link TEXT NOT NULL UNIQUE,
  begun_at TEXT NOT NULL DEFAULT '',
  came_by TEXT NOT NULL DEFAULT '',
  ended TEXT NOT NULL DEFAULT '') STRICT;
CREATE TABLE records(
  session INTEGER NOT NULL REFERENCES sessions(number),
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  content TEXT NOT NULL,
  kept_at TEXT NOT NULL,
  PRIMARY KEY(session, position),
  UNIQUE(session, name)) STRICT, WITHOUT ROWID;
PRAGMA application_id = 1835623790;
PRAGMA user_version = 2;
)";

/// In all versions, where it is needed.
constexpr const char* step_table = R"(
CREATE TABLE IF NOT EXISTS steps(
  place INTEGER PRIMARY KEY,
  chain TEXT NOT NULL,
  step INTEGER NOT NULL,
  person INTEGER NOT NULL,
  content TEXT NOT NULL,
  session INTEGER REFERENCES sessions(number),
  UNIQUE(chain, step, person)) STRICT;
)";

/// From version 1 to 2.
constexpr const char* store_conversion = R"(
ALTER TABLE sessions ADD COLUMN ended TEXT NOT NULL DEFAULT '';
PRAGMA user_version = 2;
)";
static_assert(store_application_id == 1835623790);

constexpr std::string_view record_columns =
    "SELECT session, position, name, content, kept_at FROM records";

std::vector<StoredRecord> read_records(Statement& statement) {
  std::vector<StoredRecord> records;
  while (statement.step())
    records.push_back({.session = static_cast<int>(statement.number(0)),
                       .position = static_cast<int>(statement.number(1)),
                       .name = statement.text(2),
                       .content = statement.text(3),
                       .stored_at = statement.text(4)});
  return records;
}

/// Whether a file has content and no write-ahead log beside it.
bool is_without_log(const std::filesystem::path& file) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file, unknown);
  return !unknown && size > 0 && !std::filesystem::exists(file.string() + "-wal", unknown);
}

void insert_session(Database& database, const StoredSession& session) {
  Statement statement(
      database,
      "INSERT INTO sessions(number, plan, participant, link, begun_at, came_by, ended) "
      "VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7)");
  statement
      .with(session.index, session.plan, session.participant, session.link, session.begun_at,
            session.entry_route, session.ended)
      .finish();
}

void insert_record(Database& database, const StoredRecord& record) {
  Statement statement(database,
                      "INSERT INTO records(session, position, name, content, kept_at) "
                      "VALUES(?1, ?2, ?3, ?4, ?5)");
  statement.with(record.session, record.position, record.name, record.content, record.stored_at)
      .finish();
}

void insert_step(Database& database, const StoredStep& step) {
  Statement statement(
      database,
      "INSERT INTO steps(chain, step, person, content, session) VALUES(?1, ?2, ?3, ?4, ?5)");
  statement.with(step.chain, step.step, step.person, step.content, step.session.value()).finish();
}

}  // namespace

SessionStore::SessionStore(const std::filesystem::path& file, DatabaseUse use)
    : lacks_log_(is_without_log(file)), use_(use), database_(file, use) {
  prepare();
  if (use_ == DatabaseUse::read) return;
  database_.run(step_table);
  // What is deleted is overwritten by zeros.
  database_.run("PRAGMA secure_delete = ON");
  // Written to the file itself and not to its log alone, so that a copy without the log is
  // recognised.
  database_.run("INSERT OR REPLACE INTO facts(name, value) VALUES('open', '1')");
  database_.run("PRAGMA wal_checkpoint(TRUNCATE)");
}

SessionStore::~SessionStore() {
  if (use_ == DatabaseUse::read) return;
  try {
    database_.run("DELETE FROM facts WHERE name = 'open'");
  } catch (const std::exception&) {  // a full disk: the file remains marked as having a log
    database_.keep_log();
  }
}

void SessionStore::refuse_missing_log(bool is_new) {
  if (!lacks_log_) return;
  if (!is_new) {
    Statement open(database_, "SELECT value FROM facts WHERE name = 'open'");
    if (!open.with().step()) return;
  }
  const std::string log = database_.file().string() + "-wal";
  throw Error({database_.file().string()},
              "was copied or restored while being served, without " + log +
                  ", which holds the latest answers",
              "stop the server (Ctrl-C), then copy it again, or copy both; with an empty file of "
              "that name, serving continues with the remaining answers");
}

void SessionStore::prepare() {
  const std::int64_t mark = database_.pragma("application_id");
  const std::int64_t version = database_.pragma("user_version");
  if (mark == store_application_id && (version == store_version || version == 1)) {
    refuse_missing_log(false);
    has_ends_ = version > 1 || use_ == DatabaseUse::change;
    if (version == 1 && use_ == DatabaseUse::change) convert();
    return;
  }
  Statement tables(database_, "SELECT count(*) FROM sqlite_schema");
  tables.with().step();
  const bool is_new = mark == 0 && version == 0 && tables.number(0) == 0;
  tables.with();
  if (mark == store_application_id)
    throw Error({database_.file().string()},
                "answers in a format of version " + std::to_string(version) +
                    ", which this version of mien does not know",
                "serve it with the version of mien that made it");
  if (!is_new)
    throw Error({database_.file().string()}, "is a different kind of database",
                "name another file");
  refuse_missing_log(true);
  has_tables_ = use_ == DatabaseUse::change;
  if (!has_tables_) return;
  Transaction transaction(database_);
  database_.run(store_tables);
  transaction.commit();
}

void SessionStore::convert() {
  Transaction transaction(database_);
  database_.run(store_conversion);
  transaction.commit();
}

std::optional<std::string> SessionStore::fact(const std::string& name) {
  const std::lock_guard lock(mutex_);
  Statement statement(database_, "SELECT value FROM facts WHERE name = ?1");
  if (!statement.with(name).step()) return std::nullopt;
  return statement.text(0);
}

void SessionStore::add_to_count(const std::string& name) {
  const std::lock_guard lock(mutex_);
  Statement(database_,
            "INSERT INTO facts(name, value) VALUES(?1, '1') ON CONFLICT(name) DO UPDATE SET "
            "value = CAST(CAST(value AS INTEGER) + 1 AS TEXT)")
      .with(name)
      .finish();
  empty_erased_log();
}

void SessionStore::begin(const std::vector<std::pair<std::string, std::string>>& facts,
                         const std::vector<StoredSession>& sessions) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  Statement fact(database_, "INSERT INTO facts(name, value) VALUES(?1, ?2)");
  for (const auto& [name, value] : facts) fact.with(name, value).finish();
  for (const StoredSession& one : sessions) insert_session(database_, one);
  transaction.commit();
}

void SessionStore::add(const StoredSession& session, const StoredRecord& first) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  insert_session(database_, session);
  insert_record(database_, first);
  transaction.commit();
  empty_erased_log();
}

std::vector<StoredSession> SessionStore::sessions() {
  const std::lock_guard lock(mutex_);
  std::vector<StoredSession> sessions;
  if (!has_tables_) return sessions;
  Statement statement(database_,
                      std::string("SELECT number, plan, participant, link, begun_at, came_by, ") +
                          (has_ends_ ? "ended" : "''") + " FROM sessions ORDER BY number");
  while (statement.step())
    sessions.push_back({.index = static_cast<int>(statement.number(0)),
                        .plan = static_cast<int>(statement.number(1)),
                        .participant = statement.text(2),
                        .link = statement.text(3),
                        .begun_at = statement.text(4),
                        .entry_route = statement.text(5),
                        .ended = statement.text(6)});
  return sessions;
}

bool SessionStore::mark_begun(int session, const std::string& entry_route, const std::string& now) {
  const std::lock_guard lock(mutex_);
  Statement statement(database_,
                      "UPDATE sessions SET begun_at = ?2, came_by = ?3 "
                      "WHERE number = ?1 AND begun_at = ''");
  return statement.with(session, now, entry_route).finish() > 0;
}

RecordOutcome SessionStore::keep(const StoredRecord& record, const std::string& ended,
                                 const StepChange& change) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(database_);
  Statement stored(database_, "SELECT content FROM records WHERE session = ?1 AND name = ?2");
  if (stored.with(record.session, record.name).step())
    return stored.text(0) == record.content ? RecordOutcome::same : RecordOutcome::other;
  Statement count(database_, "SELECT count(*) FROM records WHERE session = ?1");
  count.with(record.session).step();
  if (count.number(0) != record.position) return RecordOutcome::out_of_order;
  insert_record(database_, record);
  if (change.added) insert_step(database_, *change.added);
  for (const StoredStep& step : change.removed) {
    Statement removed(database_,
                      "DELETE FROM steps WHERE chain = ?1 AND step = ?2 AND person = ?3");
    removed.with(step.chain, step.step, step.person).finish();
  }
  if (!ended.empty()) {
    Statement end(database_, "UPDATE sessions SET ended = ?2 WHERE number = ?1");
    end.with(record.session, ended).finish();
  }
  // A read statement that is still open would block the commit.
  count.with();
  transaction.commit();
  empty_erased_log();
  return RecordOutcome::stored;
}

int SessionStore::erase_records(int session, const std::string& ended) {
  const std::lock_guard lock(mutex_);
  int erased = 0;
  {
    Transaction transaction(database_);
    Statement records(database_, "DELETE FROM records WHERE session = ?1");
    erased = records.with(session).finish();
    Statement steps(database_, "UPDATE steps SET session = NULL WHERE session = ?1");
    steps.with(session).finish();
    Statement end(database_,
                  "UPDATE sessions SET ended = ?2, begun_at = '', came_by = '' WHERE number = ?1");
    end.with(session, ended).finish();
    transaction.commit();
  }
  has_erased_log_ = true;  // older pages are still there
  empty_erased_log();
  return erased;
}

bool SessionStore::has_erased_log() const {
  const std::lock_guard lock(mutex_);
  return has_erased_log_;
}

/// What was erased stays erased, and records stay stored, where this fails; it is tried again
/// later.
void SessionStore::empty_erased_log() {
  if (!has_erased_log_) return;
  try {
    database_.run("PRAGMA wal_checkpoint(TRUNCATE)");
    has_erased_log_ = false;
  } catch (const WriteFailure&) {
  }
}

std::vector<StoredStep> SessionStore::steps() {
  const std::lock_guard lock(mutex_);
  Statement statement(database_,
                      "SELECT chain, step, person, content, coalesce(session, -1) FROM steps "
                      "ORDER BY place");
  std::vector<StoredStep> steps;
  while (statement.step()) {
    StoredStep step{.chain = statement.text(0),
                    .step = static_cast<int>(statement.number(1)),
                    .person = static_cast<int>(statement.number(2)),
                    .content = statement.text(3)};
    if (const auto session = static_cast<int>(statement.number(4)); session >= 0)
      step.session = session;
    steps.push_back(std::move(step));
  }
  return steps;
}

std::vector<StoredRecord> SessionStore::records() {
  const std::lock_guard lock(mutex_);
  if (!has_tables_) return {};
  Statement statement(database_, std::string(record_columns) + " ORDER BY session, position");
  return read_records(statement);
}

std::vector<StoredRecord> SessionStore::records_of(int session) {
  const std::lock_guard lock(mutex_);
  if (!has_tables_) return {};
  Statement statement(database_,
                      std::string(record_columns) + " WHERE session = ?1 ORDER BY position");
  return read_records(statement.with(session));
}

std::string random_link() {
  std::array<unsigned char, 16> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the system provides no random numbers");
  std::string link;
  for (const unsigned char byte : bytes) {
    constexpr char digits[] = "0123456789abcdef";
    link += digits[byte >> 4];
    link += digits[byte & 15];
  }
  return link;
}

}  // namespace mien::pipeline
