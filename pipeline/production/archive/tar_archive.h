#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// How a tar archive is compressed.
enum class Compression { none, gzip, zstd };

/// The compression by the file's ending: .tar, .tar.gz or .tgz, .tar.zst. Throws Error for others.
Compression compression_of(const std::filesystem::path& archive);

/// A tar archive (POSIX pax) in the making. The same files in the same order give the same bytes
/// with the same library: every file is of 1970, of user and group 0 and of mode 644, and one
/// thread compresses.
///
/// It is written under another name in the same folder and is there under its own once all of it is
/// on the disk; one that is not finished leaves nothing behind.
class TarArchive {
 public:
  /// Throws std::runtime_error when it cannot be made.
  TarArchive(std::filesystem::path file, Compression compression);
  ~TarArchive();
  TarArchive(const TarArchive&) = delete;
  TarArchive& operator=(const TarArchive&) = delete;

  /// Begins a file of so many bytes, which `add` then has to bring. Throws std::runtime_error.
  void begin(const std::string& path, std::uint64_t size);
  void add(std::string_view bytes);

  /// Throws std::runtime_error, also when the disk is full.
  void finish();

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

/// For `mien version`: "3.6.2".
std::string archive_library();

}  // namespace mien::pipeline
