#pragma once

#include <cmath>
#include <filesystem>
#include <vector>

#include "render/video/video.h"

namespace mien::render::test {

/// A smooth picture that moves with the frame's number.
inline Image8 smooth_frame(int width, int height, int number) {
  Image8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double phase = 0.05 * (x + 2 * number);
      image.at(x, y)[0] = static_cast<std::uint8_t>(128.0 + 90.0 * std::sin(phase));
      image.at(x, y)[1] = static_cast<std::uint8_t>(128.0 + 90.0 * std::cos(0.04 * y));
      image.at(x, y)[2] = static_cast<std::uint8_t>(128.0 + 90.0 * std::sin(0.03 * (x + y)));
    }
  }
  return image;
}

inline std::vector<Image8> smooth_frames(int width, int height, int count) {
  std::vector<Image8> frames;
  for (int i = 0; i < count; ++i) frames.push_back(smooth_frame(width, height, i));
  return frames;
}

inline void write_video(const std::filesystem::path& path, const std::vector<Image8>& frames,
                        FrameRate rate = {30, 1}, VideoKind kind = VideoKind::mp4) {
  VideoWriter video(
      path,
      {.width = frames.front().width, .height = frames.front().height, .rate = rate, .kind = kind});
  for (const Image8& frame : frames) video.write(frame);
  video.finish();
}

}  // namespace mien::render::test
