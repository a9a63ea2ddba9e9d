#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace mien {

/// A file or folder of ours could not be written: no fault of what the user wrote, and perhaps gone
/// the next time (a disk that was full, a server that was away). The command line turns it into
/// exit code 1.
class WriteFailure : public std::runtime_error {
 public:
  explicit WriteFailure(const std::string& text, std::error_code code = {})
      : runtime_error(text), code_(code) {}

  /// Why, if the system has said so.
  const std::error_code& code() const { return code_; }

 private:
  std::error_code code_;
};

/// "out.bvh: cannot be written (No space left on device); make room": the path, the system's own
/// reason, and what mends that.
WriteFailure cannot_be_written(const std::filesystem::path& file, std::error_code code);

namespace motion {

/// A file that people are given, while it is made: all of it takes its place at once, or nothing
/// does and the older file of that name stays. It is written beside its place, in the same folder,
/// and removed unless it is published, also when the program is interrupted.
///
/// A link keeps pointing where it does, and the older file's permissions are kept. What is no file
/// (/dev/null, a pipe) is written where it is.
class ResultFile {
 public:
  /// Makes an empty file beside the place. Throws WriteFailure, also when a folder lies there.
  explicit ResultFile(std::filesystem::path target);
  ~ResultFile();
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  const std::filesystem::path& target() const { return target_; }

  /// Where to write; its name ends with that of the target, or with its ending.
  const std::filesystem::path& draft() const { return draft_; }

  /// A message that names the draft as one that names the target.
  std::string told(std::string message) const;

  /// Waits until the bytes are on the disk and puts them in their place. To be called once.
  /// Throws WriteFailure.
  void publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path place_;  ///< the target, or what it is a link to
  std::filesystem::path draft_;
  bool is_own_ = false;  ///< the draft is there, and this object's to remove
};

/// Creates or replaces a file of these bytes, as ResultFile does. Throws WriteFailure.
void write_result(const std::filesystem::path& target, std::string_view bytes);

/// Writes the bytes into the file itself, and does not wait for the disk: for what is published by
/// other means, such as a store's artifacts. Throws WriteFailure.
void write_in_place(const std::filesystem::path& file, std::string_view bytes);

/// Removes the drafts of all results that are being written: for a program that ends at once.
void remove_unfinished_results() noexcept;

}  // namespace motion
}  // namespace mien
