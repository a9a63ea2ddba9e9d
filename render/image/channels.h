#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien::render {

/// A picture with arbitrary named channels.
struct Channels {
  int width = 0;
  int height = 0;
  std::vector<std::string> names;
  std::vector<float> values;  ///< one per name for each pixel; rows from top to bottom
};

/// Reads the first picture in a file of any format that OpenImageIO supports: integers as fractions
/// of full scale, channels in the library's order. Throws Error when the file is not a picture, is
/// too large (picture_limits.h) or is truncated.
Channels read_channels(const std::filesystem::path& path);

}  // namespace mien::render
