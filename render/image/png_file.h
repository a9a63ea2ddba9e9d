#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace mien::render {

// Reading and writing of opaque PNG files by libpng, which is loaded in any case. OpenImageIO would
// load 100 MB of libraries, and most runs read and write no other pictures than a study's frames.

/// Interleaved RGB pixels of 8 or 16 bits per channel, row by row, in native byte order.
struct PngPixels {
  int width = 0;
  int height = 0;
  int bits = 8;  ///< per channel
  const void* values = nullptr;
};

/// Writes the pixels with the tags that OpenImageIO 2.4 writes for sRGB. Throws Error.
void write_png_file(const std::filesystem::path& path, const PngPixels& pixels);

/// An open PNG file whose header has been read.
class PngFile {
 public:
  /// Throws Error when it cannot be opened or is not a PNG.
  explicit PngFile(const std::filesystem::path& path);
  ~PngFile();
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  int width() const;
  int height() const;
  int channels() const;
  int bits() const;  ///< per channel

  /// Reads all rows into `values`, which must have room for them; may be called once. Throws Error
  /// when the file is truncated or damaged.
  void read(void* values);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Version of libpng, for provenance records: "1.6.39".
std::string png_library();

}  // namespace mien::render
