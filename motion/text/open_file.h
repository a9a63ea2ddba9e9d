#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace mien::motion {

/// A regular file that is open for reading, and closed with the object.
class OpenFile {
 public:
  /// Opens a file of at most `most_bytes`, without ever blocking on a writer. `error` says why that
  /// is not possible, as `read_error` (file_contents.h); it is empty otherwise.
  OpenFile(const std::filesystem::path& path, std::uintmax_t most_bytes);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  const std::string& error() const { return error_; }
  int number() const { return number_; }  ///< its descriptor
  std::uintmax_t size() const { return size_; }

  /// The first bytes of the file, at most `count`; fewer if it is shorter or cannot be read.
  std::string beginning(std::size_t count) const;

 private:
  int number_ = -1;
  std::uintmax_t size_ = 0;
  std::string error_;
};

}  // namespace mien::motion
