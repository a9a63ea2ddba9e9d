#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// How a tar archive is compressed.
enum class Compression { none, gzip, zstd };

/// Returns the compression by the file's extension: .tar, .tar.gz or .tgz, .tar.zst. Throws Error
/// for any other.
Compression compression_of(const std::filesystem::path& archive);

/// Writes a tar archive (POSIX pax). The same files in the same order give the same bytes with the
/// same library: every file has the date 1970-01-01, user and group 0 and mode 644, and compression
/// is single-threaded.
///
/// The archive is written under a temporary name in the same folder and renamed once all of it is
/// on disk; an unfinished archive is removed.
class TarArchive {
 public:
  /// Throws std::runtime_error if the archive cannot be created.
  TarArchive(std::filesystem::path file, Compression compression);
  ~TarArchive();
  TarArchive(const TarArchive&) = delete;
  TarArchive& operator=(const TarArchive&) = delete;

  /// Begins a file of `size` bytes, which must then be supplied by `add`. Throws
  /// std::runtime_error.
  void begin(const std::string& path, std::uint64_t size);
  void add(std::string_view bytes);

  /// Completes the archive. Throws std::runtime_error, for instance if the disk is full.
  void finish();

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

/// Returns the version of the archive library, "3.6.2", for `mien version`.
std::string archive_library();

}  // namespace mien::pipeline
