#pragma once

#include <span>
#include <string>

#include "render/scene/scene.h"

namespace mien::render {

/// What a picture's channels are: colours, which sRGB encodes, or numbers as they are, 0 … 1.
enum class TextureUse { colour, numbers };

/// A picture file's bytes (PNG, JPEG, WebP) as a texture:
/// colours become linear, an alpha channel is left out, grey becomes three equal channels. Pictures
/// wider or higher than `largest` pixels are halved until they are not. `name` is for messages.
///
/// Throws Error when the bytes do not decode or the picture is larger than are read
/// (picture_limits.h).
Texture read_texture(std::span<const unsigned char> bytes, const std::string& name,
                     TextureUse use = TextureUse::colour, int largest = 1024);

/// The texture as a PNG of 8 bits a channel: the inverse of `read_texture`, but for rounding.
/// Throws Error.
std::string texture_png(const Texture& texture, TextureUse use);

}  // namespace mien::render
