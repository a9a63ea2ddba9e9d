#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace mien::pipeline {

/// Version of the SQLite library that stores answers: "3.40.1".
std::string database_library();

/// Whether a file may be changed.
enum class DatabaseUse { change, read };

/// A SQLite file, locked exclusively while this object exists. A committed transaction has been
/// flushed to disk (write-ahead log, synchronised at every commit). Not thread-safe.
class Database {
 public:
  /// Opens or creates the file. Throws Error if it cannot be opened, is not a SQLite file or is
  /// locked by another process, and WriteFailure if it cannot be written.
  ///
  /// With DatabaseUse::read, the file must exist. Neither it nor its write-ahead log is changed,
  /// and the errors are thrown by the first reading.
  explicit Database(const std::filesystem::path& file, DatabaseUse use = DatabaseUse::change);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Executes statements without bound values, separated by semicolons. Throws as fail() does.
  void run(const char* statements);

  /// The integer value of a SQLite pragma, such as "user_version".
  std::int64_t pragma(const std::string& name);

  /// Leaves the write-ahead log next to the file on destruction, as if the process had been killed.
  void keep_log();

  const std::filesystem::path& file() const { return file_; }
  sqlite3* handle() const { return database_; }

  /// Throws SQLite's last error: Error if another process has locked the file, or if it is damaged
  /// or not a SQLite file; otherwise WriteFailure.
  [[noreturn]] void fail() const;

 private:
  void lock_file();
  void lock_unchanged();

  std::filesystem::path file_;
  sqlite3* database_ = nullptr;
};

/// A prepared statement; values are bound as parameters, never inserted into the text.
class Statement {
 public:
  Statement(Database& database, std::string_view text);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Resets the statement and binds values to "?1", "?2", … in order.
  template <class... Values>
  Statement& with(const Values&... values) {
    start();
    int at = 0;
    (bind(++at, values), ...);
    return *this;
  }

  /// Advances to the next row. Returns false after the last row. Throws as Database::fail() does.
  bool step();

  /// Steps to the end. Returns the number of changed rows. Throws as Database::fail() does.
  int finish();

  std::int64_t number(int column) const;
  std::string text(int column) const;
  bool is_null(int column) const;

 private:
  void start();
  void bind(int at, std::int64_t value);
  void bind(int at, int value) { bind(at, std::int64_t{value}); }
  void bind(int at, const std::string& value);

  Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// A database transaction, rolled back by the destructor unless it was committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// Commits the changes and flushes them to disk. Throws as Database::fail() does.
  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

}  // namespace mien::pipeline
