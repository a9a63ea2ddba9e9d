#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/study/server/database.h"

namespace mien::pipeline {

/// A participant's place in a study.
struct StoredSession {
  int index = 0;            ///< from 0
  int plan = 0;             ///< which of the study's plans it follows
  std::string participant;  ///< "p001"
  std::string link;         ///< that nobody can guess
  std::string begun_at;     ///< ISO time; empty: nobody has come yet
  std::string came_by;      ///< "link" or "join"; empty: nobody has come yet
};

/// What a participant gave.
struct StoredRecord {
  int session = 0;      ///< index
  int position = 0;     ///< 0, 1, … in the order of the session
  std::string name;     ///< "trial-7"
  std::string content;  ///< text that is kept as it is
  std::string kept_at;  ///< ISO time
};

enum class Keeping {
  kept,         ///< it is on the disk
  same,         ///< it was there already
  other,        ///< something else was there, and stays
  out_of_order  ///< what goes before is not there
};

/// Sessions of a study and what was given in them, in a file that outlives the server however it
/// ends. For several threads. What is said to be kept is on the disk; with a disk that is full,
/// WriteFailure is thrown, nothing is kept, and the same may be tried again.
class SessionStore {
 public:
  /// Opens a file, or makes it. Throws Error when it is something else, was written by a later
  /// version, is open in another process, or is a copy that was made while a server had it and
  /// that lacks the log beside it (FILE-wal), in which the latest records are.
  explicit SessionStore(const std::filesystem::path& file);
  ~SessionStore();
  SessionStore(const SessionStore&) = delete;
  SessionStore& operator=(const SessionStore&) = delete;

  const std::filesystem::path& file() const { return database_.file(); }

  /// What is told once of the whole study: "design". Nothing if it was not.
  std::optional<std::string> fact(const std::string& name);
  /// Facts and sessions of a new store, all or none of them.
  void begin(const std::vector<std::pair<std::string, std::string>>& facts,
             const std::vector<StoredSession>& sessions);

  std::vector<StoredSession> sessions();
  /// A session and what is given in it first, both or neither.
  void add(const StoredSession& session, const StoredRecord& first);

  /// Notes that somebody has come; false when somebody had before.
  bool come(int session, const std::string& came_by, const std::string& now);

  Keeping keep(const StoredRecord& record);

  std::vector<StoredRecord> records();
  std::vector<StoredRecord> records_of(int session);

 private:
  void prepare();
  void refuse_lack_of_log(bool is_new);

  std::mutex mutex_;
  bool lacks_log_ = false;  ///< there was a file, and no log beside it
  Database database_;
};

/// 128 random bits of the system as 32 hexadecimal digits. Throws std::runtime_error without any.
std::string random_link();

}  // namespace mien::pipeline
