#pragma once

#include <filesystem>
#include <string>

#include "render/image/framebuffer.h"
#include "render/image/image.h"
#include "render/image/layers.h"
#include "render/image/tone.h"

namespace mien::render {

/// PNG with 8 or 16 bits a channel, tagged sRGB. The same picture gives the same bytes: no date and
/// no software name is written. The file's name must end in ".png". Throws Error.
void write_png(const std::filesystem::path& path, const Image8& image);
void write_png(const std::filesystem::path& path, const Image16& image);

/// PNG with alpha, 8 bits a channel, from light multiplied by alpha: colours are divided by it, as
/// PNG has them. `exposure.alpha` is not empty.
void write_png(const std::filesystem::path& path, const RenderTarget& target, const Tone& tone);

enum class ExrDepth { Half, Float };

/// OpenEXR, linear Rec.709, zip-compressed; no date and no software name. The file's name must end
/// in ".exr". Throws Error.
void write_exr(const std::filesystem::path& path, const Framebuffer& framebuffer,
               ExrDepth depth = ExrDepth::Half);

/// All layers as the parts of one OpenEXR: "beauty" (R, G, B), "albedo" (R, G, B), "normal" (X, Y,
/// Z), "position" (X, Y, Z), "depth" (Z), "motion" (X, Y), "samples" (Y), "variance" (Y), and
/// "crypto_figure" and "crypto_part" as Cryptomatte has them (three levels of two ranks; manifest
/// in the header). 32-bit floats, for ids and places are no colours. Throws Error.
void write_layers(const std::filesystem::path& path, const Layers& layers);

/// Every pixel of a file that the functions above wrote. Throws Error when it is not such a file,
/// is cut short or does not decode.
Image8 read_png8(const std::filesystem::path& path);
Image16 read_png16(const std::filesystem::path& path);
Framebuffer read_exr(const std::filesystem::path& path);

/// What a picture file holds. All of it is decoded: one that is cut short throws Error.
struct ImageSummary {
  std::string format;  ///< "png", "openexr"
  int width = 0;
  int height = 0;
  int channels = 0;
  int bits = 0;             ///< a channel
  std::string color_space;  ///< as tagged: "sRGB", "Linear", …
};
ImageSummary check_image(const std::filesystem::path& path);

/// For the provenance: "OpenImageIO 2.4.7".
std::string image_library();

}  // namespace mien::render
