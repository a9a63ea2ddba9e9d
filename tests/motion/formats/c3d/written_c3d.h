#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mien::test {

/// A writer of C3D files for tests, made from the format's description and independent of the
/// reader.
struct WrittenC3d {
  int processor = 84;  ///< 84 Intel, 85 DEC, 86 MIPS
  bool floats = true;
  double scale = 0.5;  ///< of integers
  double rate = 100.0;
  std::vector<std::string> labels = {"LASI", "RASI"};
  /// Frame by frame and point by point: x, y, z and the fourth value.
  std::vector<std::vector<std::array<double, 4>>> frames;
  int analog = 0;  ///< values a frame
  int first_frame = 1;
  int last_frame = 0;  ///< 0: of `frames`
  std::string unit = "mm";
  std::string more;  ///< further groups and parameters, by the functions below
  bool with_point_rate = true;

  void put_word(std::string& bytes, int value) const {
    const auto word = static_cast<std::uint16_t>(value);
    const char low = static_cast<char>(word & 0xff);
    const char high = static_cast<char>(word >> 8);
    bytes += processor == 86 ? high : low;
    bytes += processor == 86 ? low : high;
  }

  void put_float(std::string& bytes, double value) const {
    // DEC's exponents are larger by two, and its 16-bit halves change places.
    const auto bits =
        std::bit_cast<std::uint32_t>(static_cast<float>(processor == 85 ? 4.0 * value : value));
    const std::array<int, 4> order = processor == 84   ? std::array<int, 4>{0, 1, 2, 3}
                                     : processor == 85 ? std::array<int, 4>{2, 3, 0, 1}
                                                       : std::array<int, 4>{3, 2, 1, 0};
    for (const int byte : order) bytes += static_cast<char>(bits >> (8 * byte) & 0xff);
  }

  std::string group(int id, const std::string& name) const {
    std::string bytes = {static_cast<char>(name.size()), static_cast<char>(-id)};
    bytes += name;
    put_word(bytes, 3);
    return bytes + '\0';
  }

  std::string parameter(int id, const std::string& name, int type, const std::vector<int>& sizes,
                        const std::string& data) const {
    std::string bytes = {static_cast<char>(-static_cast<int>(name.size())), static_cast<char>(id)};
    bytes += name;
    put_word(bytes, static_cast<int>(2 + 2 + sizes.size() + data.size() + 1));
    bytes += static_cast<char>(type);
    bytes += static_cast<char>(sizes.size());
    for (const int size : sizes) bytes += static_cast<char>(size);
    return bytes + data + '\0';
  }

  std::string texts(int id, const std::string& name, const std::vector<std::string>& values) const {
    std::string data;
    for (const std::string& value : values) data += value + std::string(32 - value.size(), ' ');
    return parameter(id, name, -1, {32, static_cast<int>(values.size())}, data);
  }

  std::string words(int id, const std::string& name, const std::vector<int>& values) const {
    std::string data;
    for (const int value : values) put_word(data, value);
    return parameter(id, name, 2, {static_cast<int>(values.size())}, data);
  }

  std::string floats_of(int id, const std::string& name, const std::vector<double>& values,
                        std::vector<int> sizes = {}) const {
    std::string data;
    for (const double value : values) put_float(data, value);
    if (sizes.empty() && values.size() > 1) sizes = {static_cast<int>(values.size())};
    return parameter(id, name, 4, sizes, data);
  }

  std::string point_group(int data_block) const {
    std::string bytes = group(1, "POINT");
    bytes += words(1, "USED", {static_cast<int>(labels.size())});
    bytes += words(1, "DATA_START", {data_block});
    bytes += floats_of(1, "SCALE", {floats ? -scale : scale});
    if (with_point_rate) bytes += floats_of(1, "RATE", {rate});
    if (!unit.empty()) bytes += texts(1, "UNITS", {unit});
    for (std::size_t first = 0, part = 1; first < labels.size(); first += 255, ++part) {
      const std::size_t last = std::min(labels.size(), first + 255);
      bytes += texts(1, part == 1 ? "LABELS" : "LABELS" + std::to_string(part),
                     {labels.begin() + static_cast<std::ptrdiff_t>(first),
                      labels.begin() + static_cast<std::ptrdiff_t>(last)});
    }
    return bytes;
  }

  std::string header(int data_block) const {
    std::string bytes = {2, 0x50};
    put_word(bytes, static_cast<int>(labels.size()));
    put_word(bytes, analog);
    put_word(bytes, first_frame);
    put_word(bytes,
             last_frame != 0 ? last_frame : first_frame + static_cast<int>(frames.size()) - 1);
    put_word(bytes, 10);
    put_float(bytes, floats ? -scale : scale);
    put_word(bytes, data_block);
    put_word(bytes, analog > 0 ? 1 : 0);
    put_float(bytes, rate);
    return bytes + std::string(512 - bytes.size(), '\0');
  }

  std::string points() const {
    std::string bytes;
    const auto put = [&](double value) {
      if (floats) {
        put_float(bytes, value);
      } else {
        put_word(bytes, static_cast<int>(std::lround(value)));
      }
    };
    for (const auto& frame : frames) {
      for (const std::array<double, 4>& point : frame) {
        for (std::size_t i = 0; i < 4; ++i) put(i < 3 && !floats ? point[i] / scale : point[i]);
      }
      for (int i = 0; i < analog; ++i) put(-7 - i);
    }
    return bytes;
  }

  static std::string in_blocks(std::string bytes) {
    return bytes + std::string((512 - bytes.size() % 512) % 512, '\0');
  }

  /// Blocks of the parameter section; the data begin at this number + 2.
  int parameter_blocks() const {
    return static_cast<int>(in_blocks("1234" + point_group(0) + more + '\0').size() / 512);
  }

  std::string bytes() const {
    const int blocks = parameter_blocks();
    std::string section = {1, 0x50, static_cast<char>(blocks), static_cast<char>(processor)};
    section += point_group(blocks + 2) + more + '\0';
    return header(blocks + 2) + in_blocks(section) + in_blocks(points());
  }
};

}  // namespace mien::test
