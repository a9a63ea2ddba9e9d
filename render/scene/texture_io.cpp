#include "render/scene/texture_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "render/error.h"
#include "render/image/tone.h"
#include "render/image_files/image_files.h"
#include "render/image_files/picture_limits.h"

namespace mien::render {

namespace {

[[noreturn]] void fail(const std::string& name, const std::string& wrong) {
  throw Error(name + ": " + wrong);
}

/// The ending by which the library knows the format.
std::string ending_of(std::span<const unsigned char> bytes, const std::string& name) {
  if (bytes.size() > 8 && bytes[0] == 0x89 && bytes[1] == 'P') return "picture.png";
  if (bytes.size() > 3 && bytes[0] == 0xFF && bytes[1] == 0xD8) return "picture.jpg";
  if (bytes.size() > 12 && bytes[0] == 'R' && bytes[8] == 'W') return "picture.webp";
  fail(name, "is neither PNG, JPEG nor WebP");
}

/// Means of two by two texels; an odd last row or column goes with its neighbour.
Texture halved(const Texture& texture) {
  Texture half;
  half.width = std::max(1, texture.width / 2);
  half.height = std::max(1, texture.height / 2);
  const auto at = [&](int x, int y) {
    x = std::min(x, texture.width - 1);
    y = std::min(y, texture.height - 1);
    return texture.texels[static_cast<size_t>(y) * static_cast<size_t>(texture.width) +
                          static_cast<size_t>(x)];
  };
  half.texels.reserve(static_cast<size_t>(half.width) * static_cast<size_t>(half.height));
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      half.texels.push_back(0.25f * (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) +
                                     at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1)));
    }
  }
  return half;
}

}  // namespace

Texture read_texture(std::span<const unsigned char> bytes, const std::string& name, TextureUse use,
                     int largest) {
  std::string error;
  const std::unique_ptr<ImageFile> file = image_files().open(bytes, ending_of(bytes, name), error);
  if (!file) fail(name, error);
  const ImageLayout& layout = file->layout();
  const size_t channels = layout.channels.size();
  require_readable_size(name, layout.width, layout.height, channels);
  std::vector<unsigned char> pixels(static_cast<size_t>(layout.width) *
                                    static_cast<size_t>(layout.height) * channels);
  if (!file->read(ChannelKind::byte, pixels.data())) fail(name, file->error());
  Texture texture;
  texture.width = layout.width;
  texture.height = layout.height;
  texture.texels.reserve(pixels.size() / channels);
  std::array<float, 256> linear;
  for (int code = 0; code < 256; ++code) {
    const double share = code / 255.0;
    linear[static_cast<size_t>(code)] =
        static_cast<float>(use == TextureUse::colour ? linear_from_srgb(share) : share);
  }
  const size_t green = channels < 3 ? 0 : 1;
  for (size_t at = 0; at < pixels.size(); at += channels) {
    texture.texels.emplace_back(linear[pixels[at]], linear[pixels[at + green]],
                                linear[pixels[at + 2 * green]]);
  }
  while (texture.width > largest || texture.height > largest) texture = halved(texture);
  return texture;
}

std::string texture_png(const Texture& texture, TextureUse use) {
  std::vector<unsigned char> codes;
  codes.reserve(3 * texture.texels.size());
  for (const Color& texel : texture.texels) {
    for (const float share : texel) {
      const double encoded = use == TextureUse::colour ? srgb_from_linear(share) : share;
      codes.push_back(
          static_cast<unsigned char>(std::lround(255.0 * std::clamp(encoded, 0.0, 1.0))));
    }
  }
  std::string bytes, error;
  const ImagePart part{.width = texture.width, .height = texture.height, .values = codes.data()};
  if (!image_files().encode("texture.png", part, bytes, error)) fail("a texture", error);
  return bytes;
}

}  // namespace mien::render
