#include "render/image_files/picture_limits.h"

#include "render/error.h"

namespace mien::render {

std::string picture_read_error(std::int64_t width, std::int64_t height, std::size_t channels) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width < 1 || height < 1 || channels < 1) return "has " + size + ", so it is empty";
  const auto columns = static_cast<std::uint64_t>(width);
  const auto rows = static_cast<std::uint64_t>(height);
  const bool is_readable = channels <= max_picture_values &&
                           columns <= max_picture_values / channels &&
                           rows <= max_picture_values / channels / columns;
  if (is_readable) return "";
  return "has " + size + ", more than the limit of 8192 x 8192 or the same number in another shape";
}

void require_readable_size(const std::string& name, std::int64_t width, std::int64_t height,
                           std::size_t channels) {
  const std::string error = picture_read_error(width, height, channels);
  if (!error.empty()) throw Error(name + ": " + error);
}

}  // namespace mien::render
