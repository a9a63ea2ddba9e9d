#include "render/image_files/image_files.h"

#include "render/parts/loaded_part.h"

namespace mien::render {

namespace {

const ImageFiles& loaded() {
  const std::string name = "mien-image-files.so", purpose = "reads and writes pictures";
  void* const part = loaded_part(name, purpose);
  auto* const entry =
      reinterpret_cast<ImageFilesEntry*>(function_of_part(part, image_files_entry, name, purpose));
  const ImageFiles* files = entry(image_files_edition);
  if (files == nullptr) fail_to_load(name, purpose, "it is of another build");
  return *files;
}

}  // namespace

const ImageFiles& image_files() {
  static const ImageFiles& files = loaded();
  return files;
}

std::string image_files_version() {
  const std::string version = version_of_library(MIEN_IMAGE_LIBRARY);
  return version.empty() ? image_files().version() : version;
}

}  // namespace mien::render
