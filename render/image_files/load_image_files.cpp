#include "render/image_files/image_files.h"
#include "render/parts/load_part.h"

namespace mien::render {

const ImageFiles& image_files() {
  static const auto* const files = static_cast<const ImageFiles*>(
      load_part("mien-image-files.so", "reads and writes pictures", image_files_edition));
  return *files;
}

std::string image_files_version() {
  const std::string version = version_of_library(MIEN_IMAGE_LIBRARY);
  return version.empty() ? image_files().version() : version;
}

}  // namespace mien::render
