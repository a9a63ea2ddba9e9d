#include "render/image_files/image_files.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <dlfcn.h>

#include "render/error.h"

namespace mien::render {

namespace {

namespace fs = std::filesystem;

constexpr char part_name[] = "mien-image-files.so";

[[noreturn]] void fail_to_load(const std::string& why) {
  throw Error(std::string(part_name) +
              ": the part of mien that reads and writes pictures cannot be loaded (" + why +
              "); install or build mien again");
}

/// What dlopen is given: the part where a build leaves it or an installation puts it, seen from the
/// program's folder, as its run path says too. That alone would not do: dlopen as AddressSanitizer
/// replaces it searches the run path of the sanitizer. The bare name, for the loader to find, when
/// it is at none of these places.
std::string part_file() {
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  if (unknown) return part_name;
  for (const char* place : {MIEN_INSTALLED_PARTS, ".", "..", "../.."}) {
    const fs::path file = (folder / place / part_name).lexically_normal();
    if (fs::is_regular_file(file, unknown)) return file.string();
  }
  return part_name;
}

const ImageFiles& loaded() {
  void* part = dlopen(part_file().c_str(), RTLD_NOW | RTLD_LOCAL);
  if (part == nullptr) fail_to_load(dlerror());
  auto* const entry = reinterpret_cast<ImageFilesEntry*>(dlsym(part, image_files_entry));
  if (entry == nullptr) fail_to_load(dlerror());
  const ImageFiles* files = entry(image_files_edition);
  if (files == nullptr) fail_to_load("it is of another build");
  return *files;
}

/// "2.4.7" of "libOpenImageIO.so.2.4.7"; empty for other names.
std::string version_in_name(const std::string& name) {
  constexpr std::string_view before = ".so.";
  const std::size_t at = name.find(before);
  if (at == name.npos) return {};
  const std::string version = name.substr(at + before.size());
  const bool has_three = std::count(version.begin(), version.end(), '.') == 2;
  return has_three ? version : std::string();
}

}  // namespace

const ImageFiles& image_files() {
  static const ImageFiles& files = loaded();
  return files;
}

std::string image_files_version() {
  std::error_code missing;
  const auto library = fs::canonical(MIEN_IMAGE_LIBRARY, missing);
  const std::string version = missing ? "" : version_in_name(library.filename().string());
  return version.empty() ? image_files().version() : version;
}

}  // namespace mien::render
