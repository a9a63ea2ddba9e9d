#include "motion/text/file_contents.h"

#include <fstream>

#include "motion/error.h"

namespace mien::motion {

std::string read_contents(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) {
    throw Error({path.string()}, "there is no such file", "check the path");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error({path.string()}, "is not a file", "give the path of a motion file");
  }
  std::ifstream stream(path, std::ios::binary);
  const auto size = std::filesystem::file_size(path, failure);
  std::string bytes;
  if (stream && !failure) {
    bytes.resize(size);
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
  }
  if (!stream || failure) {
    throw Error({path.string()}, "cannot be read", "check the file's permissions");
  }
  return bytes;
}

void write_contents(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) {
    throw Error({path.string()}, "cannot be written",
                "check that the folder exists, may be written to and has space");
  }
}

}  // namespace mien::motion
