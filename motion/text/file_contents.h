#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace mien::motion {

/// Largest sizes of files that are read, bytes: documents (YAML is limited further, to 16 MiB, when
/// it is parsed), tables (answers), and recordings and characters.
inline constexpr std::uintmax_t max_document_bytes = std::uintmax_t{64} << 20;
inline constexpr std::uintmax_t max_table_bytes = std::uintmax_t{512} << 20;
inline constexpr std::uintmax_t max_recording_bytes = std::uintmax_t{2} << 30;
inline constexpr std::uintmax_t any_size = std::numeric_limits<std::uintmax_t>::max();

/// Returns why a file cannot be read, as a phrase to follow its name: "there is no such file", "is
/// a pipe, not a file", "has 8 GiB, more than the 64 MiB that can be read". Empty if there is
/// no such reason. Only regular files are read: a pipe, a socket or a device may block or never
/// end. Does not open the file, so missing permission to read it is not noticed.
std::string read_error(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// The bytes of a file, or the reason that they could not be read.
struct FileReading {
  std::optional<std::string> bytes;
  std::string error;  ///< empty if reading succeeded
};

/// Reads a regular file of at most `most_bytes`. Never blocks on a writer.
FileReading bytes_of_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// Whether a file's bytes are a git LFS pointer instead of the file.
inline bool is_lfs_pointer(std::string_view bytes) {
  return bytes.starts_with("version https://git-lfs.github.com/spec/");
}

/// The bytes of a motion or character file; those inside it if its name ends in ".gz" and it is
/// compressed (compressed_file.h). Throws mien::Error when it cannot be read or is a git LFS
/// pointer.
std::string read_contents(const std::filesystem::path& path);

}  // namespace mien::motion
