#include "pipeline/study/server/database.h"

#include <system_error>

#include <sqlite3.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

/// The error of the failed system call, if any.
std::error_code system_code(sqlite3* database) {
  const int code = sqlite3_system_errno(database);
  return code == 0 ? std::error_code() : std::error_code(code, std::generic_category());
}

/// The path with the links among its folders resolved, so that SQLite can be told to follow none.
std::string resolved_path(const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw Error({file.string()}, "there is no folder for it", "create the folder first");
  return (std::filesystem::canonical(folder) / file.filename()).string();
}

}  // namespace

std::string database_library() { return sqlite3_libversion(); }

Database::Database(const std::filesystem::path& file, DatabaseUse use) : file_(file) {
  // A connection that could not write would leave an empty log and an index of it behind.
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOFOLLOW | SQLITE_OPEN_NOMUTEX |
                    (use == DatabaseUse::change ? SQLITE_OPEN_CREATE : 0);
  const bool is_new = !std::filesystem::exists(file);
  if (sqlite3_open_v2(resolved_path(file).c_str(), &database_, flags, nullptr) != SQLITE_OK) {
    const std::string reason = sqlite3_errmsg(database_);
    sqlite3_close(database_);
    throw Error({file.string()}, "cannot be opened: " + reason, "name another file");
  }
  try {
    // Readable by the owner alone; SQLite gives the log the same permissions.
    if (is_new)
      std::filesystem::permissions(
          file, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    if (use == DatabaseUse::change)
      lock_file();
    else
      lock_unchanged();
  } catch (...) {
    sqlite3_close(database_);
    throw;
  }
}

Database::~Database() { sqlite3_close(database_); }

void Database::lock_file() {
  run("PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;"
      "PRAGMA foreign_keys = ON; PRAGMA trusted_schema = OFF;"
      "BEGIN IMMEDIATE; COMMIT;");
}

void Database::lock_unchanged() {
  // What a killed process left in the log stays there.
  std::error_code unknown;
  if (std::filesystem::exists(file_.string() + "-wal", unknown)) keep_log();
  run("PRAGMA locking_mode = EXCLUSIVE; PRAGMA query_only = ON; PRAGMA trusted_schema = OFF;");
}

void Database::fail() const {
  const int code = sqlite3_errcode(database_);
  const std::string reason = sqlite3_errmsg(database_);
  switch (code) {
    case SQLITE_BUSY:
      throw Error({file_.string()}, "another process has it open",
                  "stop that server first, or name another file");
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
      throw Error({file_.string()}, "is not a file of answers, or is damaged: " + reason,
                  "restore a copy, or name another file");
    default:
      throw WriteFailure(file_.string() + ": cannot be written: " + reason,
                         code == SQLITE_FULL ? std::make_error_code(std::errc::no_space_on_device)
                                             : system_code(database_));
  }
}

void Database::run(const char* statements) {
  if (sqlite3_exec(database_, statements, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void Database::keep_log() {
  sqlite3_db_config(database_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

std::int64_t Database::pragma(const std::string& name) {
  Statement statement(*this, "PRAGMA " + name);
  statement.with().step();
  return statement.number(0);
}

Statement::Statement(Database& database, std::string_view text) : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), text.data(), static_cast<int>(text.size()), &statement_,
                         nullptr) != SQLITE_OK)
    database.fail();
}

Statement::~Statement() { sqlite3_finalize(statement_); }

void Statement::start() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

void Statement::bind(int at, std::int64_t value) {
  if (sqlite3_bind_int64(statement_, at, value) != SQLITE_OK) database_.fail();
}

void Statement::bind(int at, const std::string& value) {
  if (sqlite3_bind_text(statement_, at, value.data(), static_cast<int>(value.size()),
                        SQLITE_TRANSIENT) != SQLITE_OK)
    database_.fail();
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.fail();
  return false;
}

int Statement::finish() {
  while (step()) {
  }
  return sqlite3_changes(database_.handle());
}

std::int64_t Statement::number(int column) const {
  return sqlite3_column_int64(statement_, column);
}

std::string Statement::text(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  return bytes == nullptr ? std::string() : std::string(bytes, size);
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  // A full disk may have rolled it back already.
  if (is_open_ && sqlite3_get_autocommit(database_.handle()) == 0)
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.run("COMMIT");
  is_open_ = false;
}

}  // namespace mien::pipeline
