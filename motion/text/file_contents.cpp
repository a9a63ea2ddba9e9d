#include "motion/text/file_contents.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "motion/error.h"
#include "motion/text/compressed_file.h"
#include "motion/text/open_file.h"

namespace mien::motion {

namespace {

/// "64 MiB", "8.5 GiB"
std::string size_text(std::uintmax_t bytes) {
  constexpr std::array units = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  auto size = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; size >= 1024.0 && unit + 1 < units.size(); ++unit) size /= 1024.0;
  std::array<char, 32> text{};
  const bool is_whole = size == static_cast<double>(static_cast<std::uintmax_t>(size));
  std::snprintf(text.data(), text.size(), is_whole ? "%.0f %s" : "%.1f %s", size, units[unit]);
  return text.data();
}

std::string unreadable(int error) {
  if (error == ENOENT || error == ENOTDIR) return "there is no such file";
  return "cannot be read (" + std::generic_category().message(error) + ")";
}

std::string status_error(const struct stat& status, std::uintmax_t most_bytes) {
  if (S_ISDIR(status.st_mode)) return "is a folder, not a file";
  if (S_ISFIFO(status.st_mode)) return "is a pipe, not a file";
  if (S_ISSOCK(status.st_mode)) return "is a socket, not a file";
  if (!S_ISREG(status.st_mode)) return "is a device, not a file";
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size <= most_bytes) return "";
  return "has " + size_text(size) + ", more than the " + size_text(most_bytes) +
         " that can be read";
}

FileReading failed_reading(std::string problem) { return {std::nullopt, std::move(problem)}; }

/// A file may grow while it is read, or not know its size.
FileReading read_to_end(int file, std::uintmax_t size, std::uintmax_t most_bytes) {
  constexpr std::size_t step = 1 << 16;
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(size) + step);
  for (;;) {
    const std::size_t before = bytes.size();
    bytes.resize(before + step);
    const ssize_t count = ::read(file, bytes.data() + before, step);
    if (count < 0 && errno != EINTR) return failed_reading(unreadable(errno));
    bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (bytes.size() > most_bytes)
      return failed_reading("has more than the " + size_text(most_bytes) + " that can be read");
    if (count == 0) return {std::move(bytes), ""};
  }
}

}  // namespace

std::string read_error(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return unreadable(errno);
  return status_error(status, most_bytes);
}

OpenFile::OpenFile(const std::filesystem::path& path, std::uintmax_t most_bytes)
    : error_(read_error(path, most_bytes)) {
  // Looked at before it is opened, because opening a device may do something.
  if (!error_.empty()) return;
  number_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  struct stat status {};
  const bool is_open = number_ >= 0 && ::fstat(number_, &status) == 0;
  error_ = is_open ? status_error(status, most_bytes) : unreadable(errno);
  size_ = static_cast<std::uintmax_t>(status.st_size);
}

OpenFile::~OpenFile() {
  if (number_ >= 0) ::close(number_);
}

std::string OpenFile::beginning(std::size_t count) const {
  std::string bytes(count, '\0');
  const ssize_t there = ::pread(number_, bytes.data(), count, 0);
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(there, 0)));
  return bytes;
}

FileReading bytes_of_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  const OpenFile file(path, most_bytes);
  if (!file.error().empty()) return failed_reading(file.error());
  return read_to_end(file.number(), file.size(), most_bytes);
}

std::string read_contents(const std::filesystem::path& path) {
  FileReading reading = bytes_of_file(path, max_recording_bytes);
  if (!reading.bytes) throw Error({path.string()}, reading.error, "give the path of a motion file");
  if (is_lfs_pointer(*reading.bytes))
    throw Error({path.string()}, "is a git LFS pointer; the file itself has not been fetched",
                "run: git lfs pull");
  const bool is_compressed = is_gzip(*reading.bytes) && without_compression(path) != path;
  if (is_compressed) return inflated(*reading.bytes, path.string());
  return *std::move(reading.bytes);
}

}  // namespace mien::motion
