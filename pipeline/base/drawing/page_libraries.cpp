#include "pipeline/base/drawing/page_libraries.h"

#include <array>
#include <optional>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas_surface.h"
#include "render/parts/load_part.h"

namespace mien::pipeline {

namespace {

std::optional<std::array<int, 3>> three_numbers(const std::string& text) {
  std::array<int, 3> numbers{};
  int read = 0;
  const int count =
      std::sscanf(text.c_str(), "%d.%d.%d%n", &numbers[0], &numbers[1], &numbers[2], &read);
  if (count != 3 || static_cast<std::size_t>(read) != text.size()) return std::nullopt;
  return numbers;
}

}  // namespace

const PageLibraries& page_libraries() {
  static const auto* const libraries = static_cast<const PageLibraries*>(
      render::load_part("mien-pages.so", "draws sheets and charts", page_libraries_edition));
  return *libraries;
}

// The second number is 10000 major + 100 minor + micro; the third is 0, since Cairo 1.18 the micro
// once more.
std::string cairo_release(const std::string& file_version) {
  const auto numbers = three_numbers(file_version);
  if (!numbers || (*numbers)[0] != 2 || (*numbers)[1] < 10000) return {};
  const int release = (*numbers)[1];
  if ((*numbers)[2] != 0 && (*numbers)[2] != release % 100) return {};
  return fmt::format("{}.{}.{}", release / 10000, release / 100 % 100, release % 100);
}

// The second and the third number together are 100 minor + micro; the major one is 1.
std::string pango_release(const std::string& file_version) {
  const auto numbers = three_numbers(file_version);
  if (!numbers || (*numbers)[0] != 0 || (*numbers)[1] < 100 || (*numbers)[2] < 0) return {};
  const int release = (*numbers)[1] + (*numbers)[2];
  return fmt::format("1.{}.{}", release / 100, release % 100);
}

std::string cairo_library() {
  const std::string release = cairo_release(render::version_of_library(MIEN_CAIRO));
  return release.empty() ? page_libraries().cairo_version() : release;
}

std::string pango_library() {
  const std::string release = pango_release(render::version_of_library(MIEN_PANGO));
  return release.empty() ? page_libraries().pango_version() : release;
}

}  // namespace mien::pipeline
