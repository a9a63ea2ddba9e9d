#include "motion/text/file_contents.h"

#include <fstream>
#include <vector>

#include "motion/error.h"

namespace mien::motion {

std::optional<std::string> bytes_of_file(const std::filesystem::path& path) {
  std::error_code failure;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path, failure)) return std::nullopt;
  std::string bytes;
  std::vector<char> buffer(1 << 16);
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    bytes.append(buffer.data(), static_cast<size_t>(stream.gcount()));
  }
  if (stream.bad()) return std::nullopt;
  return bytes;
}

std::string read_contents(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) {
    throw Error({path.string()}, "there is no such file", "check the path");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error({path.string()}, "is not a file", "give the path of a motion file");
  }
  if (std::optional<std::string> bytes = bytes_of_file(path)) return *std::move(bytes);
  throw Error({path.string()}, "cannot be read", "check the file's permissions");
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
