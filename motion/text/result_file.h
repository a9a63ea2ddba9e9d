#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace mien {

/// An output file or folder could not be written: not an error in the user's input, and possibly
/// temporary (a full disk, an unreachable server). The command line returns exit code 1 for it.
class WriteFailure : public std::runtime_error {
 public:
  explicit WriteFailure(const std::string& text, std::error_code code = {})
      : runtime_error(text), code_(code) {}

  /// The system's error code, if there is one.
  const std::error_code& code() const { return code_; }

 private:
  std::error_code code_;
};

/// "out.bvh: cannot be written (No space left on device); free some space, and try again": the
/// path, the system's reason, and the remedy if one is known.
WriteFailure cannot_be_written(const std::filesystem::path& file, std::error_code code);

namespace motion {

/// An output file that is written atomically: it replaces the older file of that name completely,
/// or not at all. It is written as a draft in the same folder; unless published, the draft is
/// removed, even if the program is interrupted.
///
/// If the target is a link, the file that it points to is replaced; the permissions of the older
/// file are kept. Special files (/dev/null, a pipe) are written directly.
class ResultFile {
 public:
  /// Creates an empty draft in the target's folder. Throws WriteFailure, also if the target is a
  /// folder.
  explicit ResultFile(std::filesystem::path target);
  ~ResultFile();
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  const std::filesystem::path& target() const { return target_; }

  /// The path to write to. Its name ends with the target's name, or at least with its extension.
  const std::filesystem::path& draft() const { return draft_; }

  /// The message with the draft's name replaced by the target's.
  std::string with_target_name(std::string message) const;

  /// Flushes the draft to disk and replaces the target with it. Must be called at most once. Throws
  /// WriteFailure.
  void publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path place_;  ///< the target, or the file to which it links
  std::filesystem::path draft_;
  bool is_own_ = false;  ///< the draft exists and must be removed by this object
};

/// Creates or replaces a file with these bytes, like ResultFile. Throws WriteFailure.
void write_result(const std::filesystem::path& target, std::string_view bytes);

/// Writes the bytes directly into the file, without flushing to disk, for files that are published
/// by other means, such as a store's artifacts. Throws WriteFailure.
void write_in_place(const std::filesystem::path& file, std::string_view bytes);

/// Removes the drafts of all unfinished results, for a program that exits immediately.
void remove_unfinished_results() noexcept;

}  // namespace motion
}  // namespace mien
