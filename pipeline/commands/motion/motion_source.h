#pragma once

#include <optional>
#include <stop_token>
#include <string>

namespace mien::pipeline {

/// Bytes of a file, a pipe or standard input ("-") as they come.
class MotionSource {
 public:
  /// Throws Error when there is no such file, or it is a folder.
  explicit MotionSource(const std::string& file);
  ~MotionSource();
  MotionSource(const MotionSource&) = delete;
  MotionSource& operator=(const MotionSource&) = delete;

  /// As error messages call it.
  const std::string& name() const { return name_; }

  /// Waits for the next bytes. None at the end, or once `stop` is asked for. Throws
  /// std::system_error when reading fails.
  std::optional<std::string> next(const std::stop_token& stop);

 private:
  std::string name_;
  int descriptor_ = -1;
};

}  // namespace mien::pipeline
