#include "pipeline/regression/compared_pictures.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "render/image/image_io.h"

namespace mien::pipeline {

namespace {

/// Black, purple, orange, near white: lighter is worse.
constexpr std::array<std::array<float, 3>, 5> heat = {
    {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}}};

std::array<std::uint8_t, 3> heat_colour(float error) {
  const float place = std::clamp(error, 0.0f, 1.0f) * static_cast<float>(heat.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), heat.size() - 2);
  const float share = place - static_cast<float>(below);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>((1.0f - share) * heat[below][c] +
                                          share * heat[below + 1][c] + 0.5f);
  return colour;
}

render::Image8 heat_map(const render::PixelMap& error) {
  render::Image8 picture(error.width, error.height);
  for (std::size_t i = 0; i < error.values.size(); ++i)
    std::ranges::copy(heat_colour(error.values[i]),
                      picture.channels.begin() + static_cast<std::ptrdiff_t>(3 * i));
  return picture;
}

void put_picture(const std::filesystem::path& file, const render::Image8& picture) {
  ResultFile result(file);
  render::write_png(result.draft(), picture);
  result.publish();
}

}  // namespace

std::filesystem::path ComparedPictures::file(const std::string& id, int frame,
                                             const char* what) const {
  return folder_ / fmt::format("{}-{:05}-{}.png", id, frame, what);
}

std::filesystem::path ComparedPictures::before(const std::string& id, int frame) const {
  return file(id, frame, "before");
}

std::filesystem::path ComparedPictures::now(const std::string& id, int frame) const {
  return file(id, frame, "now");
}

std::filesystem::path ComparedPictures::flip(const std::string& id, int frame) const {
  return file(id, frame, "flip");
}

void ComparedPictures::put_before(const std::string& id, int frame,
                                  const render::Image8& picture) const {
  make_folder(folder_);
  put_picture(before(id, frame), picture);
}

void ComparedPictures::put_now(const std::string& id, int frame,
                               const render::Image8& picture) const {
  make_folder(folder_);
  put_picture(now(id, frame), picture);
}

void ComparedPictures::put(const std::string& id, int frame, const render::Image8& picture_before,
                           const render::Image8& picture_now, const render::PixelMap& error) const {
  put_before(id, frame, picture_before);
  put_now(id, frame, picture_now);
  if (!error.values.empty()) put_picture(flip(id, frame), heat_map(error));
}

}  // namespace mien::pipeline
