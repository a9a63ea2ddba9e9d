#include "motion/formats/motion_file.h"

#include <algorithm>
#include <system_error>

#include "motion/error.h"
#include "motion/formats/acclaim.h"
#include "motion/formats/bvh.h"
#include "motion/formats/gltf.h"

namespace mien::motion {

namespace {

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

bool is_motion_file(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  return extension == ".bvh" || extension == ".amc" || extension == ".gltf" || extension == ".glb";
}

bool may_hold_takes(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  return extension == ".gltf" || extension == ".glb";
}

Recording read_motion(const std::filesystem::path& path, const std::optional<std::string>& take) {
  const std::string extension = extension_of(path);
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) {
    throw Error({path.string(), 0, 0}, "is a folder", "name a motion file in it");
  }
  if (take && is_motion_file(path) && !may_hold_takes(path)) {
    throw Error({path.string(), 0, 0}, "holds one motion, so no take can be chosen",
                "omit the take; glTF files (.gltf, .glb) can hold several");
  }
  if (extension == ".bvh") return read_bvh(path);
  if (extension == ".amc") return read_amc(path);
  if (extension == ".gltf" || extension == ".glb") return read_gltf(path, take);
  throw Error({path.string(), 0, 0}, "is not a motion file that can be read",
              "use BVH (.bvh), Acclaim (.amc) or glTF (.gltf, .glb)");
}

Recording read_take(const std::filesystem::path& path, const std::string& take) {
  return read_motion(path, take.empty() ? std::nullopt : std::optional(take));
}

void write_motion(const Recording& recording, const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".bvh") return write_bvh(recording, path);
  if (extension == ".glb") return write_glb(recording, path);
  throw Error({path.string(), 0, 0}, "is not a motion file that can be written",
              "use BVH (.bvh) or binary glTF (.glb)");
}

}  // namespace mien::motion
