#include "render/parts/load_part.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include <dlfcn.h>

#include "render/error.h"

namespace mien::render {

namespace {

namespace fs = std::filesystem;

/// What dlopen is given: the part where a build leaves it or an installation puts it, seen from the
/// program's folder, as its run path says too. That alone would not do: dlopen as AddressSanitizer
/// replaces it searches the run path of the sanitizer. The bare name, for the loader to find, when
/// it is at none of these places.
std::string file_of(const std::string& name) {
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  if (unknown) return name;
  for (const char* place : {MIEN_INSTALLED_PARTS, ".", "..", "../.."}) {
    const fs::path file = (folder / place / name).lexically_normal();
    if (fs::is_regular_file(file, unknown)) return file.string();
  }
  return name;
}

}  // namespace

const void* load_part(const std::string& name, const std::string& purpose, int edition) {
  const auto fail = [&](const std::string& why) {
    return Error(name + ": the part of mien that " + purpose + " cannot be loaded (" + why +
                 "); install or build mien again");
  };
  void* const part = dlopen(file_of(name).c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const entry = part == nullptr ? nullptr : dlsym(part, "mien_part");
  if (entry == nullptr) throw fail(dlerror());
  const void* const interface = reinterpret_cast<PartEntry*>(entry)(edition);
  if (interface == nullptr) throw fail("it belongs to a different build");
  return interface;
}

std::string version_of_library(const fs::path& library) {
  std::error_code missing;
  const std::string name = fs::canonical(library, missing).filename().string();
  constexpr std::string_view before = ".so.";
  const std::size_t at = missing ? name.npos : name.find(before);
  if (at == name.npos) return {};
  const std::string version = name.substr(at + before.size());
  return std::count(version.begin(), version.end(), '.') == 2 ? version : std::string();
}

}  // namespace mien::render
