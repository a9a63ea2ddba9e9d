#pragma once

#include <filesystem>
#include <string>

#include "render/image/framebuffer.h"
#include "render/image/image.h"
#include "render/image/layers.h"
#include "render/image/tone.h"

namespace mien::render {

/// Writes a PNG with 8 or 16 bits per channel, tagged sRGB. The same picture gives the same bytes:
/// no date and no software name is written. Throws Error.
void write_png(const std::filesystem::path& path, const Image8& image);
void write_png(const std::filesystem::path& path, const Image16& image);

/// Writes a PNG with alpha, 8 bits per channel. The target's colours, which are multiplied by
/// alpha, are divided by it, as PNG requires. `target.alpha` must not be empty, and the file's name
/// must end in ".png". Throws Error.
void write_png(const std::filesystem::path& path, const RenderTarget& target, const Tone& tone);

enum class ExrDepth { Half, Float };

/// Writes an OpenEXR file, linear Rec.709, zip-compressed; no date and no software name. The file's
/// name must end in ".exr". Throws Error.
void write_exr(const std::filesystem::path& path, const Framebuffer& framebuffer,
               ExrDepth depth = ExrDepth::Half);

/// Writes all layers as the parts of one OpenEXR file: "beauty" (R, G, B), "albedo" (albedo.R, …),
/// "normal" (normal.X, …), "position" (position.X, …), "depth" (depth.Z), "motion" (motion.X,
/// motion.Y), "samples" (samples.Y), "variance" (variance.Y), and "crypto_figure" and "crypto_part"
/// in the layout of Cryptomatte (three levels of two ranks; manifest in the header). All values are
/// 32-bit floats, since half precision does not suffice for ids and positions. Throws Error.
void write_layers(const std::filesystem::path& path, const Layers& layers);

/// Reads all pixels of a PNG of 8 or 16 bits per channel, or of the first part of an OpenEXR file.
/// Throws Error when the file has another format or not three channels, is too large
/// (picture_limits.h), or does not decode.
Image8 read_png8(const std::filesystem::path& path);
Image16 read_png16(const std::filesystem::path& path);
Framebuffer read_exr(const std::filesystem::path& path);

/// Properties of the first picture in a file, found by decoding it; throws Error if that fails.
struct ImageSummary {
  std::string format;  ///< "png", "openexr"
  int width = 0;
  int height = 0;
  int channels = 0;
  int bits = 0;             ///< per channel
  std::string color_space;  ///< as tagged: "sRGB", "Linear", …
};
ImageSummary check_image(const std::filesystem::path& path);

/// Name and version of the library, for provenance records: "OpenImageIO 2.4.7".
std::string image_library();

}  // namespace mien::render
