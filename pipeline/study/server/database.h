#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace mien::pipeline {

/// Version of the library that keeps answers: "3.40.1".
std::string database_library();

/// A SQLite file that this process has to itself until it ends, however it ends. What a transaction
/// has committed is on the disk (write-ahead log, synchronised at every commit). For one thread at
/// a time.
class Database {
 public:
  /// Makes the file unless it is there. Throws Error when it is no SQLite file or another process
  /// has it, and WriteFailure when it cannot be written.
  explicit Database(const std::filesystem::path& file);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Statements without values, one after the other. Throws WriteFailure.
  void run(const char* statements);

  /// A number that the file keeps about itself: "user_version".
  std::int64_t pragma(const std::string& name);

  /// Leaves the log beside the file when this ends, as a kill would.
  void keep_log();

  const std::filesystem::path& file() const { return file_; }
  sqlite3* handle() const { return database_; }

  /// Throws what the last fault was: WriteFailure for a full or failing disk, or Error.
  [[noreturn]] void fail() const;

 private:
  void take();

  std::filesystem::path file_;
  sqlite3* database_ = nullptr;
};

/// A prepared statement: values are bound, never written into it.
class Statement {
 public:
  Statement(Database& database, std::string_view text);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Values for "?1", "?2", … in their order.
  template <class... Values>
  Statement& with(const Values&... values) {
    start();
    int at = 0;
    (bind(++at, values), ...);
    return *this;
  }

  /// Goes to the next row; false after the last. Throws WriteFailure.
  bool step();

  /// Steps to the end; the number of rows that were changed.
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

/// Undoes what was done in it unless it was committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// It is on the disk when this returns. Throws WriteFailure.
  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

}  // namespace mien::pipeline
