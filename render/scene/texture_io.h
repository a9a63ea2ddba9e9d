#pragma once

#include <span>
#include <string>

#include "render/scene/scene.h"

namespace mien::render {

/// The meaning of a picture's channels: colours encoded as sRGB, or plain numbers, 0 … 1.
enum class TextureUse { colour, numbers };

/// Decodes the bytes of a picture file (PNG, JPEG, WebP) as a texture: colours become linear, an
/// alpha channel is dropped, grey becomes three equal channels. Pictures wider or higher than
/// `largest` pixels are halved until they fit. `name` is used in messages.
///
/// Throws Error when the bytes do not decode or the picture exceeds the limits (picture_limits.h).
Texture read_texture(std::span<const unsigned char> bytes, const std::string& name,
                     TextureUse use = TextureUse::colour, int largest = 1024);

/// Encodes the texture as a PNG of 8 bits per channel: the inverse of `read_texture`, except for
/// rounding. Throws Error.
std::string texture_png(const Texture& texture, TextureUse use);

}  // namespace mien::render
