#include "pipeline/base/documents/files.h"

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "motion/error.h"
#include "motion/text/file_contents.h"

namespace mien::pipeline {

namespace {

[[noreturn]] void throw_errno(const std::filesystem::path& file) {
  throw std::system_error(errno, std::generic_category(), file.string());
}

/// An open file that closes itself.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags)
      : number_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) throw_errno(file);
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

std::string read_file(const std::filesystem::path& file) {
  motion::FileReading reading = motion::bytes_of_file(file, motion::max_recording_bytes);
  if (reading.bytes) return *std::move(reading.bytes);
  throw std::runtime_error(file.string() + ": " + reading.error);
}

void refuse_special_file(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) return;
  const std::string problem = motion::read_error(file, motion::any_size);
  if (!problem.empty()) throw Error({file.string()}, problem, "name a file");
}

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  motion::write_result(file, bytes);
}

void replace_file(const std::filesystem::path& file, const std::filesystem::path& next,
                  std::string_view bytes) {
  try {
    motion::write_in_place(next, bytes);
    std::filesystem::rename(next, file);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(next, ignored);
    throw;
  }
}

std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error))
    paths.push_back(at->path());
  return paths;
}

void make_folder(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  throw WriteFailure(folder.string() + ": cannot be made (" + error.message() +
                         "); name a folder that can be written to",
                     error);
}

void flush_to_disk(const std::filesystem::path& file) {
  const Descriptor descriptor(file, O_RDONLY);
  if (::fsync(descriptor.number()) != 0) throw_errno(file);
}

}  // namespace mien::pipeline
