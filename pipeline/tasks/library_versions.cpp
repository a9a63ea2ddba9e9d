#include <string>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <xxhash.h>

#include "pipeline/base/drawing/page_libraries.h"
#include "pipeline/tasks/code_identity.h"
#include "render/image/image_io.h"
#include "render/image/png_file.h"
#include "render/tracer/tracer.h"
#include "render/video/video.h"

#include "program_version.h"

namespace mien::pipeline {

namespace {

std::string dotted(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> library_versions() {
  return {
      {"compiler", __VERSION__},
      {"Cairo", cairo_library()},
      {"CLI11", CLI11_VERSION},
      {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"Embree", render::Tracer().description()},
      {"FFmpeg", render::video_libraries()},
      {"fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"libpng", render::png_library()},
      {"nlohmann_json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                               NLOHMANN_JSON_VERSION_PATCH)},
      {"OpenImageIO", render::image_library()},
      {"Pango", pango_library()},
      {"xxHash", dotted(static_cast<int>(XXH_versionNumber() / 10000),
                        static_cast<int>(XXH_versionNumber() / 100 % 100),
                        static_cast<int>(XXH_versionNumber() % 100))},
      {"yaml-cpp", yaml_cpp_version_text},
  };
}

}  // namespace mien::pipeline
