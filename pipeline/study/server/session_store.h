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
  std::string link;         ///< secret part of its address (random_link)
  std::string begun_at;     ///< ISO 8601 time of the first visit; empty: not begun
  std::string entry_route;  ///< "link" or "join"; empty: not begun
};

/// A record that the page of a participant has sent.
struct StoredRecord {
  int session = 0;        ///< index
  int position = 0;       ///< 0, 1, … in the order of the session
  std::string name;       ///< "trial-7"
  std::string content;    ///< stored without change
  std::string stored_at;  ///< ISO 8601 time of storing
};

enum class RecordOutcome {
  stored,       ///< stored; it is on the disk
  same,         ///< the same record was stored before
  other,        ///< another record was stored at that position, and remains
  out_of_order  ///< an earlier record of the session is missing
};

/// The sessions of a study and their records, in a database file that survives a crash of the
/// server. Thread-safe. What a call reports as stored is on the disk. On a full disk a call throws
/// WriteFailure and stores nothing; it may be repeated.
class SessionStore {
 public:
  /// Opens a file, or creates it. Throws Error when it is not a session store, was written by a
  /// later version, is open in another process, or was copied from a running server without its
  /// write-ahead log (FILE-wal), which has the latest records.
  explicit SessionStore(const std::filesystem::path& file);
  ~SessionStore();
  SessionStore(const SessionStore&) = delete;
  SessionStore& operator=(const SessionStore&) = delete;

  const std::filesystem::path& file() const { return database_.file(); }

  /// A property of the whole study, such as "design"; nullopt when it was not stored.
  std::optional<std::string> fact(const std::string& name);
  /// Stores the properties and sessions of a new study in one transaction.
  void begin(const std::vector<std::pair<std::string, std::string>>& facts,
             const std::vector<StoredSession>& sessions);

  std::vector<StoredSession> sessions();
  /// Stores a further session and its first record in one transaction.
  void add(const StoredSession& session, const StoredRecord& first);

  /// Marks a session as begun at `now`; false when it had begun before.
  bool mark_begun(int session, const std::string& entry_route, const std::string& now);

  RecordOutcome keep(const StoredRecord& record);

  std::vector<StoredRecord> records();
  std::vector<StoredRecord> records_of(int session);

 private:
  void prepare();
  void refuse_missing_log(bool is_new);

  std::mutex mutex_;
  bool lacks_log_ = false;  ///< the file existed without its log
  Database database_;
};

/// 128 bits from the system's random generator, as 32 hexadecimal digits. Throws std::runtime_error
/// when it fails.
std::string random_link();

}  // namespace mien::pipeline
