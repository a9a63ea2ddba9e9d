#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/study/server/database.h"

namespace mien::pipeline {

/// A session of a study, for one participant.
struct StoredSession {
  int index = 0;            ///< from 0
  int plan = 0;             ///< index of the session plan that it follows
  std::string participant;  ///< "p001"
  std::string link;         ///< secret part of its web address (random_link)
  std::string begun_at;     ///< ISO 8601 time of storing the first record; empty if not begun
  std::string entry_route;  ///< "link" or "join"; empty if not begun
  std::string ended;        ///< word of an early end, after which nothing is stored; or empty
};

/// A record that the page of a participant has sent.
struct StoredRecord {
  int session = 0;        ///< index of the session
  int position = 0;       ///< 0, 1, … within the session
  std::string name;       ///< "trial-7"
  std::string content;    ///< stored without change
  std::string stored_at;  ///< ISO 8601 time of storing
};

/// An answer to a step of a chain that goes across participants, in an adaptive experiment. It
/// stays when its participant withdraws, because the answers of others depend on it.
struct StoredStep {
  std::string chain;  ///< "sad/1"
  int step = 0;
  int person = 0;
  std::string content;         ///< the answer, which does not identify the participant
  std::optional<int> session;  ///< index of the session; unset after withdrawal
};

/// What a record changes in the chains.
struct StepChange {
  std::optional<StoredStep> added;  ///< nobody may have answered this step before
  std::vector<StoredStep> removed;  ///< answers that no longer count; their content is not read
};

/// The outcome of storing a record.
enum class RecordOutcome {
  stored,       ///< the record was stored and flushed to disk
  same,         ///< an identical record had been stored before
  other,        ///< a different record of that name had been stored and is kept
  out_of_order  ///< `position` is not the number of records that the session has so far
};

/// The sessions of a study and their records, in a database file that survives a crash of the
/// server. Thread-safe. When a call returns, its changes are on the disk. On a full disk, a call
/// throws WriteFailure and stores nothing; it may be repeated.
class SessionStore {
 public:
  /// Opens or creates a file; one of an earlier format is converted. Throws Error if it is not a
  /// session store, has a later version of the format, is open in another process, or was copied
  /// from a running server without its write-ahead log (FILE-wal), which contains the latest
  /// records.
  ///
  /// With DatabaseUse::read, the file is not changed, nor converted. Only `sessions`, `records` and
  /// `records_of` may then be called; an empty file has no sessions.
  explicit SessionStore(const std::filesystem::path& file, DatabaseUse use = DatabaseUse::change);
  ~SessionStore();
  SessionStore(const SessionStore&) = delete;
  SessionStore& operator=(const SessionStore&) = delete;

  const std::filesystem::path& file() const { return database_.file(); }

  /// A property of the whole study, such as "design"; nullopt if it was not stored.
  std::optional<std::string> fact(const std::string& name);
  /// Stores the properties and sessions of a new study in one transaction.
  void begin(const std::vector<std::pair<std::string, std::string>>& facts,
             const std::vector<StoredSession>& sessions);

  /// Adds 1 to a property that is a number, or sets it to 1.
  void add_to_count(const std::string& name);

  std::vector<StoredSession> sessions();
  /// Stores an additional session and its first record in one transaction.
  void add(const StoredSession& session, const StoredRecord& first);

  /// Marks a session as begun at `now`. Returns false if it had begun before.
  bool mark_begun(int session, const std::string& entry_route, const std::string& now);

  /// Stores a record of an existing session. `ended` is stored with it, if the record ends the
  /// session early, and so is what it changes in the chains.
  RecordOutcome keep(const StoredRecord& record, const std::string& ended = "",
                     const StepChange& change = {});

  /// Deletes all records of a session and the times at which it began, removes its number from
  /// answers to steps, and stores how it ended.
  /// What was deleted is overwritten in the file and its write-ahead log; if there is no space to
  /// empty the log, has_erased_log() is true until a later call of `add`, `add_to_count` or `keep`
  /// has emptied it, or the store is closed. Returns the number of deleted records.
  int erase_records(int session, const std::string& ended);

  /// Whether the write-ahead log still contains what was deleted.
  bool has_erased_log() const;

  /// Answers to steps of chains in the order in which they were stored.
  std::vector<StoredStep> steps();

  std::vector<StoredRecord> records();
  std::vector<StoredRecord> records_of(int session);

 private:
  void prepare();
  void convert();
  void refuse_missing_log(bool is_new);
  void empty_erased_log();

  mutable std::mutex mutex_;
  bool lacks_log_ = false;  ///< the file existed without its log
  DatabaseUse use_ = DatabaseUse::change;
  bool has_tables_ = true;       ///< false: an empty file that is only read
  bool has_ends_ = true;         ///< false: a file of version 1 that is only read
  bool has_erased_log_ = false;  ///< of has_erased_log()
  Database database_;
};

/// 128 bits from the system's random number generator as 32 hexadecimal digits. Throws
/// std::runtime_error if the generator fails.
std::string random_link();

}  // namespace mien::pipeline
