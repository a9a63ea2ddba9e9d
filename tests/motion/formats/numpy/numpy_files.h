#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <zlib.h>

namespace mien::test {

/// An .npy file after numpy.lib.format, written apart from the project's own writer. `shape` is the
/// text of the tuple.
inline std::string npy_file(const std::string& descr, const std::string& shape,
                            const std::string& elements, bool fortran = false, int version = 1) {
  const std::string dictionary = "{'descr': " + descr +
                                 ", 'fortran_order': " + (fortran ? "True" : "False") +
                                 ", 'shape': " + shape + ", }";
  const std::size_t length = (dictionary.size() + 64) / 64 * 64 + 64;
  std::string text = dictionary + std::string(length - dictionary.size() - 1, ' ') + "\n";
  std::string file = "\x93NUMPY";
  file += static_cast<char>(version);
  file += '\0';
  for (int i = 0; i < (version == 1 ? 2 : 4); ++i)
    file += static_cast<char>(text.size() >> (8 * i) & 255);
  return file + text + elements;
}

/// The bytes of numbers, as on the machine (little endian) or reversed.
template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers, bool big_endian = false) {
  std::string bytes;
  for (const Number number : numbers) {
    char part[sizeof number];
    std::memcpy(part, &number, sizeof number);
    bytes += big_endian ? std::string(std::rbegin(part), std::rend(part))
                        : std::string(part, sizeof number);
  }
  return bytes;
}

inline std::string npy_f8(const std::string& shape, const std::vector<double>& numbers) {
  return npy_file("'<f8'", shape, bytes_of(numbers));
}

inline std::string npy_text(const std::vector<std::string>& texts, std::size_t letters,
                            bool is_single = false) {
  std::string bytes;
  for (const std::string& text : texts)
    for (std::size_t i = 0; i < letters; ++i) {
      bytes += i < text.size() ? text[i] : '\0';
      bytes += std::string(3, '\0');
    }
  return npy_file("'<U" + std::to_string(letters) + "'",
                  is_single ? "()" : "(" + std::to_string(texts.size()) + ",)", bytes);
}

struct ZipMember {
  std::string name;
  std::string bytes;
  bool is_deflated = false;
  int flags = 0;                  ///< 1: encrypted
  std::int64_t stated_size = -1;  ///< instead of the true one
};

/// A zip archive after PKWARE's APPNOTE, with the crc bit by bit.
inline std::string zip_file(const std::vector<ZipMember>& members) {
  const auto crc = [](const std::string& bytes) {
    std::uint32_t remainder = ~0U;
    for (const char byte : bytes) {
      remainder ^= static_cast<unsigned char>(byte);
      for (int bit = 0; bit < 8; ++bit)
        remainder = remainder >> 1U ^ (remainder & 1U ? 0xEDB88320U : 0U);
    }
    return ~remainder;
  };
  const auto number = [](std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255U);
    return text;
  };
  std::string zip;
  std::string directory;
  for (const ZipMember& member : members) {
    std::string packed = member.bytes;
    if (member.is_deflated) {
      uLongf size = compressBound(static_cast<uLong>(packed.size()));
      packed.resize(size);
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(member.bytes.data()),
                static_cast<uLong>(member.bytes.size()), 6);
      packed = packed.substr(2, size - 6);  // without zlib's own header and checksum
    }
    const std::uint64_t size = member.stated_size >= 0
                                   ? static_cast<std::uint64_t>(member.stated_size)
                                   : member.bytes.size();
    const std::string common = number(20, 2) + number(static_cast<std::uint64_t>(member.flags), 2) +
                               number(member.is_deflated ? 8 : 0, 2) + number(0, 4) +
                               number(crc(member.bytes), 4) + number(packed.size(), 4) +
                               number(size, 4) + number(member.name.size(), 2) + number(0, 2);
    directory += "PK\x01\x02" + number(20, 2) + common + number(0, 2) + number(0, 2) +
                 number(0, 2) + number(0, 4) + number(zip.size(), 4) + member.name;
    zip += "PK\x03\x04" + common + member.name + packed;
  }
  return zip + directory + "PK\x05\x06" + number(0, 4) + number(members.size(), 2) +
         number(members.size(), 2) + number(directory.size(), 4) + number(zip.size(), 4) +
         number(0, 2);
}

/// Stored, with ".npy" after each name.
inline std::string npz_file(std::vector<ZipMember> members) {
  for (ZipMember& member : members) member.name += ".npy";
  return zip_file(members);
}

}  // namespace mien::test
