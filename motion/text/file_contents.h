#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace mien::motion {

/// Most bytes that are read of a file: of a text that people write (manifest, scales, recipes,
/// set), of a table (answers), and of a recording or a character.
inline constexpr std::uintmax_t most_of_document = std::uintmax_t{64} << 20;
inline constexpr std::uintmax_t most_of_table = std::uintmax_t{512} << 20;
inline constexpr std::uintmax_t most_of_recording = std::uintmax_t{2} << 30;
inline constexpr std::uintmax_t any_size = std::numeric_limits<std::uintmax_t>::max();

/// What hinders reading a file, in words that follow its name: "there is no such file", "is a pipe
/// and no file", "has 8 GiB, more than the 64 MiB that are read". Empty when nothing does. Only
/// regular files are read: a pipe, a socket or a device may never come to an end, or never begin.
/// Opens nothing.
std::string hindrance_of(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// A file's bytes, or what hinders reading them.
struct FileReading {
  std::optional<std::string> bytes;
  std::string hindrance;  ///< empty when there are bytes
};

/// Reads a regular file of at most so many bytes. Never waits for anybody to write.
FileReading bytes_of_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// Whether a file's bytes are what git keeps in place of a large file (git LFS).
inline bool is_lfs_pointer(std::string_view bytes) {
  return bytes.starts_with("version https://git-lfs.github.com/spec/");
}

/// The bytes of a motion's or character's file. Throws mien::Error when something hinders reading
/// it.
std::string read_contents(const std::filesystem::path& path);

/// Writes the bytes, replacing a file of that name. Throws mien::Error when that fails.
void write_contents(const std::filesystem::path& path, std::string_view bytes);

}  // namespace mien::motion
