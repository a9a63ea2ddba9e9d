#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace mien::render {

// Opaque PNG by libpng itself, which is loaded anyway: OpenImageIO brings 100 MB of libraries into
// memory, and a study's frames are the only pictures that most runs read and write.

/// Three channels of 8 or 16 bits as they lie in memory, row by row.
struct PngPixels {
  int width = 0;
  int height = 0;
  int bits = 8;  ///< a channel
  const void* values = nullptr;
};

/// Writes exactly the bytes that OpenImageIO 2.4 writes for the same pixels. Throws Error.
void write_png_file(const std::filesystem::path& path, const PngPixels& pixels);

/// A PNG of which the head has been read.
class PngFile {
 public:
  /// Throws Error when it is not a PNG.
  explicit PngFile(const std::filesystem::path& path);
  ~PngFile();
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  int width() const;
  int height() const;
  int channels() const;
  int bits() const;  ///< a channel

  /// Reads all rows into memory for them, once. Throws Error: cut short, damaged.
  void read(void* values);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// For the provenance: "1.6.39".
std::string png_library();

}  // namespace mien::render
