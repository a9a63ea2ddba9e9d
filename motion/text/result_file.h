#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace mien {

/// An output file or folder could not be written: not an error of the user's input, and perhaps
/// temporary (a full disk, an unreachable server). The command line turns it into exit code 1.
class WriteFailure : public std::runtime_error {
 public:
  explicit WriteFailure(const std::string& text, std::error_code code = {})
      : runtime_error(text), code_(code) {}

  /// The system's error code, if there is one.
  const std::error_code& code() const { return code_; }

 private:
  std::error_code code_;
};

/// "out.bvh: cannot be written (No space left on device); make room": the path, the system's own
/// reason, and what mends that.
WriteFailure cannot_be_written(const std::filesystem::path& file, std::error_code code);

namespace motion {

/// An output file that is written atomically: it replaces the older file of that name completely,
/// or not at all. It is written as a draft in the same folder, which is removed unless it is
/// published, also when the program is interrupted.
///
/// A link keeps its target, and the older file's permissions are kept. Special files (/dev/null, a
/// pipe) are written directly.
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

  /// The message with the draft's name replaced by the target's.
  std::string with_target_name(std::string message) const;

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

/// Removes the drafts of all unfinished results, for a program that exits immediately.
void remove_unfinished_results() noexcept;

}  // namespace motion
}  // namespace mien
