#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mien::render {

// Reading and writing of picture files by OpenImageIO. The library and its dependencies take a
// third of a second to load, so they are linked into a plug-in that is loaded when the first
// picture is read or written. The types below are the whole interface between the program and the
// plug-in.

/// The numeric type of a channel's values.
enum class ChannelKind {
  byte,    ///< 0 … 255
  word,    ///< 0 … 65,535
  half,    ///< 16-bit floating point
  single,  ///< 32-bit floating point
  other
};

/// The properties of one of a file's pictures, as the library reads them.
struct ImageLayout {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< names, in the order of the values
  ChannelKind stored = ChannelKind::other;
  int bits = 0;             ///< per channel, as the library reads it
  std::string format;       ///< "png", "openexr", …
  std::string color_space;  ///< "sRGB", "Linear"; empty if not known
};

/// A file open for reading, with one of its pictures selected, initially the first.
class ImageFile {
 public:
  virtual ~ImageFile() = default;
  virtual const ImageLayout& layout() const = 0;

  /// Selects a picture by its index, from 0. Returns false when there is none.
  virtual bool select(int picture) = 0;

  /// Reads all values, in rows from top to bottom; integers become fractions of full scale if
  /// `wanted` is a floating-point type. Returns false when the file is damaged (see error()).
  virtual bool read(ChannelKind wanted, void* values) = 0;

  virtual std::string error() const = 0;
};

/// A picture to be written.
struct ImagePart {
  int width = 0;
  int height = 0;
  int count = 3;                           ///< channels
  std::vector<std::string> channels;       ///< names; empty: R, G, B, A
  ChannelKind stored = ChannelKind::byte;  ///< type in the file
  std::vector<std::pair<std::string, std::variant<int, std::string>>> attributes;
  ChannelKind given = ChannelKind::byte;  ///< type of `values`
  /// Rows from top to bottom, channels interleaved; must outlive the call that writes them.
  const void* values = nullptr;
};

/// The values of a picture with three channels.
struct ImageValues {
  int width = 0;
  int height = 0;
  ChannelKind kind = ChannelKind::byte;
  const void* values = nullptr;
};

/// The library's comparison of two pictures; differences of integers are fractions of full scale.
struct ImageComparison {
  double mean = 0.0;
  double rms = 0.0;
  double psnr_db = 0.0;
  double largest = 0.0;
  int x = 0, y = 0, channel = 0;  ///< position of the largest difference
  std::int64_t failing = 0;       ///< pixels above the threshold
};

/// The functions of the library. Thread-safe.
class ImageFiles {
 public:
  virtual ~ImageFiles() = default;

  /// Opens a picture file. Returns null, with the reason in `error`, on failure.
  virtual std::unique_ptr<ImageFile> open(const std::string& path, std::string& error) const = 0;

  /// Opens a picture file in memory, whose bytes must outlive the result; the extension of `name`
  /// selects the format.
  virtual std::unique_ptr<ImageFile> open(std::span<const unsigned char> bytes,
                                          const std::string& name, std::string& error) const = 0;

  /// Writes a file of these pictures. Returns false, with the reason in `error`, on failure.
  virtual bool write(const std::string& path, const std::vector<ImagePart>& parts,
                     std::string& error) const = 0;

  /// Encodes a picture file in memory; the extension of `name` selects the format.
  virtual bool encode(const std::string& name, const ImagePart& part, std::string& bytes,
                      std::string& error) const = 0;

  virtual ImageComparison compare(const ImageValues& a, const ImageValues& b,
                                  float threshold) const = 0;

  virtual std::string version() const = 0;  ///< "2.4.7"
};

/// Returns the library, which is loaded on the first call. Throws Error when the plug-in cannot be
/// loaded.
const ImageFiles& image_files();

/// Returns the library's version, from its file name and without loading it if possible.
std::string image_files_version();

/// Version of the types above (load_part.h).
inline constexpr int image_files_edition = 3;

}  // namespace mien::render
