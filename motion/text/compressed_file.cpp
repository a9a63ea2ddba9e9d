#include "motion/text/compressed_file.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <optional>
#include <vector>

#include <zlib.h>

#include "motion/error.h"
#include "motion/text/frame_file_name.h"

namespace mien::motion {

namespace {

[[noreturn]] void refuse(const std::string& file, std::string_view wrong, std::string_view remedy) {
  throw Error({file}, wrong, remedy);
}

/// zlib's state for the members of a gzip file.
class GzipMembers {
 public:
  explicit GzipMembers(std::string_view bytes) : rest_(bytes) {
    constexpr int largest_window_with_gzip_header = 15 + 16;
    if (inflateInit2(&stream_, largest_window_with_gzip_header) != Z_OK) throw std::bad_alloc();
  }
  ~GzipMembers() { inflateEnd(&stream_); }
  GzipMembers(const GzipMembers&) = delete;
  GzipMembers& operator=(const GzipMembers&) = delete;

  /// Adds the next bytes to `contents`, at most `step`. False once the member has ended.
  bool inflate_more(std::string& contents, const std::string& file) {
    const auto given = static_cast<uInt>(std::min(rest_.size(), largest_piece));
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));
    stream_.avail_in = given;
    stream_.next_out = reinterpret_cast<Bytef*>(buffer_.data());
    stream_.avail_out = static_cast<uInt>(buffer_.size());
    const int status = ::inflate(&stream_, Z_NO_FLUSH);
    rest_.remove_prefix(given - stream_.avail_in);
    contents.append(buffer_.data(), buffer_.size() - stream_.avail_out);
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status == Z_STREAM_END) return false;
    if (status != Z_OK && status != Z_BUF_ERROR)
      refuse(file, "is damaged: its compressed contents cannot be read", "obtain the file again");
    // There was room for more, so what is missing has not come in.
    if (rest_.empty() && stream_.avail_out > 0)
      refuse(file, "is truncated: its compressed contents do not end", "obtain the file again");
    return true;
  }

  /// Whether another member follows.
  bool begin_next(const std::string& file) {
    rest_.remove_prefix(std::min(rest_.find_first_not_of('\0'), rest_.size()));
    if (rest_.empty()) return false;
    if (!is_gzip(rest_))
      refuse(file, "has other bytes after its compressed contents", "obtain the file again");
    inflateReset(&stream_);
    return true;
  }

 private:
  static constexpr std::size_t step = std::size_t{256} << 10;
  static constexpr std::size_t largest_piece = std::size_t{1} << 30;
  z_stream stream_{};
  std::vector<char> buffer_ = std::vector<char>(step);
  std::string_view rest_;
};

}  // namespace

std::filesystem::path without_compression(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".gz") return path;
  std::filesystem::path inner = path;
  return inner.replace_extension();
}

std::string recording_name(const std::filesystem::path& path) {
  if (const std::optional<FrameFileName> frame = frame_file_name(path)) return frame->recording;
  return without_compression(path).stem().string();
}

std::uintmax_t largest_inflated(std::uintmax_t bytes, std::uintmax_t most_bytes) {
  constexpr std::uintmax_t always = std::uintmax_t{8} << 20;
  constexpr std::uintmax_t ratio = 50;
  const std::uintmax_t by_ratio = bytes > most_bytes / ratio ? most_bytes : bytes * ratio;
  return std::min(std::max(by_ratio, always), most_bytes);
}

std::string inflated(std::string_view bytes, const std::string& file_name,
                     std::uintmax_t most_bytes) {
  const std::uintmax_t limit = largest_inflated(bytes.size(), most_bytes);
  GzipMembers members(bytes);
  std::string contents;
  do {
    while (members.inflate_more(contents, file_name) && contents.size() <= limit) {
    }
    if (contents.size() > limit) {
      refuse(file_name,
             "is compressed and has more than " + std::to_string(limit >> 20) + " MiB in it",
             "unpack it if it is a motion, and name the unpacked file");
    }
  } while (members.begin_next(file_name));
  return contents;
}

}  // namespace mien::motion
