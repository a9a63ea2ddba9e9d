#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mien::render {

// The files of pictures, as the library reads and writes them. It and what it needs take a third of
// a second to load: they lie in a part of the program that is loaded when the first picture is read
// or written. These types are all that both sides know.

/// What a channel's value is.
enum class ChannelKind {
  byte,    ///< 0 … 255
  word,    ///< 0 … 65,535
  half,    ///< 16 bits, floating
  single,  ///< 32 bits, floating
  other
};

/// What a file says of one of its pictures.
struct ImageLayout {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< names, in the order of the values
  ChannelKind stored = ChannelKind::other;
  int bits = 0;             ///< a channel, as stored
  std::string format;       ///< "png", "openexr", …
  std::string color_space;  ///< "sRGB", "Linear"; empty if not stated
};

/// A file that is open for reading, at one of its pictures: at first, the first.
class ImageFile {
 public:
  virtual ~ImageFile() = default;
  virtual const ImageLayout& layout() const = 0;

  /// Goes to a picture, counted from 0. False when there is none; `error` says why.
  virtual bool select(int picture) = 0;

  /// All values, rows from top to bottom; whole numbers become shares of full scale when something
  /// floating is wanted. False when the file is broken.
  virtual bool read(ChannelKind wanted, void* values) = 0;

  virtual std::string error() const = 0;
};

/// A picture to be written.
struct ImagePart {
  int width = 0;
  int height = 0;
  int count = 3;                      ///< channels
  std::vector<std::string> channels;  ///< names; empty: R, G, B, A
  ChannelKind stored = ChannelKind::byte;
  std::vector<std::pair<std::string, std::variant<int, std::string>>> attributes;
  ChannelKind given = ChannelKind::byte;
  const void* values = nullptr;
};

/// Values of a picture of three channels.
struct ImageValues {
  int width = 0;
  int height = 0;
  ChannelKind kind = ChannelKind::byte;
  const void* values = nullptr;
};

/// What the library finds to differ between two pictures; of whole numbers as shares of full scale.
struct ImageComparison {
  double mean = 0.0;
  double rms = 0.0;
  double psnr_db = 0.0;
  double largest = 0.0;
  int x = 0, y = 0, channel = 0;  ///< where
  std::int64_t failing = 0;       ///< pixels above the threshold
};

/// The library. For several threads.
class ImageFiles {
 public:
  virtual ~ImageFiles() = default;

  /// Opens a picture file; null, with the reason in `error`, when that fails.
  virtual std::unique_ptr<ImageFile> open(const std::string& path, std::string& error) const = 0;

  /// Opens a picture file in memory, whose bytes outlive the result; the extension of `name`
  /// selects the format.
  virtual std::unique_ptr<ImageFile> open(std::span<const unsigned char> bytes,
                                          const std::string& name, std::string& error) const = 0;

  /// Writes a file of these pictures; false, with the reason in `error`, when that fails.
  virtual bool write(const std::string& path, const std::vector<ImagePart>& parts,
                     std::string& error) const = 0;

  /// Encodes a picture file in memory; the extension of `name` selects the format.
  virtual bool encode(const std::string& name, const ImagePart& part, std::string& bytes,
                      std::string& error) const = 0;

  virtual ImageComparison compare(const ImageValues& a, const ImageValues& b,
                                  float threshold) const = 0;

  virtual std::string version() const = 0;  ///< "2.4.7"
};

/// The library, loaded when this is first called. Throws Error when it is not there.
const ImageFiles& image_files();

/// The library's version, from its file's name without loading it where possible.
std::string image_files_version();

/// Version of the types above (load_part.h).
inline constexpr int image_files_edition = 3;

}  // namespace mien::render
