#include "pipeline/commands/motion/motion_source.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "motion/error.h"
#include "motion/formats/motion_file.h"

namespace mien::pipeline {

namespace {

bool is_bvh(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".bvh" || extension == ".BVH";
}

constexpr int look_up_milliseconds = 100;  // for a wish to stop

}  // namespace

MotionSource::MotionSource(const std::string& file) : name_(file) {
  if (file == "-") {
    name_ = "standard input";
    descriptor_ = STDIN_FILENO;
    return;
  }
  if (std::filesystem::is_directory(file)) {
    throw Error(Place{file}, "is a folder", "name a BVH file, or - for standard input");
  }
  if (motion::is_motion_file(file) && !is_bvh(file)) {
    throw Error(Place{file}, "cannot be streamed: its format comes as a whole",
                "write it as BVH, with mien motion convert, or use mien motion modify");
  }
  descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) {
    throw Error(Place{file}, std::string("cannot be read: ") + std::strerror(errno),
                "name a BVH file, or - for standard input");
  }
}

MotionSource::~MotionSource() {
  if (descriptor_ > STDIN_FILENO) close(descriptor_);
}

std::optional<std::string> MotionSource::next(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    pollfd waiting{descriptor_, POLLIN, 0};
    if (poll(&waiting, 1, look_up_milliseconds) == 0) continue;
    std::array<char, 16384> bytes;
    const ssize_t count = read(descriptor_, bytes.data(), bytes.size());
    if (count > 0) return std::string(bytes.data(), static_cast<std::size_t>(count));
    if (count == 0) return std::nullopt;
    if (errno != EINTR && errno != EAGAIN) {
      throw std::system_error(errno, std::generic_category(), "reading " + name_);
    }
  }
  return std::nullopt;
}

}  // namespace mien::pipeline
