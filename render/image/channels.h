#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien::render {

/// A picture of any named channels.
struct Channels {
  int width = 0;
  int height = 0;
  std::vector<std::string> names;
  std::vector<float> values;  ///< one a name and pixel; rows from top to bottom
};

/// The first part of any file that OpenImageIO reads: whole numbers as shares of full scale,
/// channels in the library's order. Throws Error when it is no picture or is cut short.
Channels read_channels(const std::filesystem::path& path);

}  // namespace mien::render
