#include <cstdint>
#include <limits>
#include <new>

#include <zlib.h>

#include "motion/formats/numpy/npz.h"

namespace mien::motion {

namespace {

// The layout is that of APPNOTE.TXT (PKWARE), 4.3.7 local file header, 4.3.12 central directory
// header and 4.3.16 end of central directory.
constexpr unsigned version_needed = 20;
constexpr unsigned date_of_1980 = 1U << 5U | 1U;  // the first day of the format
constexpr unsigned method_stored = 0;
constexpr unsigned method_deflated = 8;
constexpr std::size_t most_bytes = std::numeric_limits<std::uint32_t>::max();

void put(std::string& zip, std::size_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) zip += static_cast<char>(number >> (8 * i) & 0xFFU);
}

struct Member {
  std::string name;
  std::size_t checksum = 0;
  std::size_t size = 0;
  std::size_t packed_size = 0;
  unsigned method = method_stored;
};

/// What both headers of a member have in common.
void put_member(std::string& zip, const Member& member) {
  put(zip, version_needed, 2);
  put(zip, 0, 2);  // flags
  put(zip, member.method, 2);
  put(zip, 0, 2);  // time
  put(zip, date_of_1980, 2);
  put(zip, member.checksum, 4);
  put(zip, member.packed_size, 4);
  put(zip, member.size, 4);
  put(zip, member.name.size(), 2);
  put(zip, 0, 2);  // extra field
}

[[noreturn]] void refuse() {
  throw Error("an .npz file of 4 GiB or more cannot be written", "save a shorter motion");
}

/// Without the header of zlib.
std::string deflated(const std::string& bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::size_t checksum_of(const std::string& bytes) {
  return crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()),
                 bytes.size());
}

}  // namespace

std::string to_npz(std::span<const NamedArray> arrays, NpzCompression compression) {
  std::string zip;
  std::string directory;
  for (const auto& [name, array] : arrays) {
    const std::string file = to_npy(array);
    if (file.size() > most_bytes / 2) refuse();
    Member member{name + ".npy", checksum_of(file), file.size(), file.size(), method_stored};
    std::string packed;
    if (compression == NpzCompression::deflated) {
      packed = deflated(file);
      member.packed_size = packed.size();
      member.method = method_deflated;
    }
    const std::size_t start = zip.size();
    put(zip, 0x04034b50, 4);
    put_member(zip, member);
    zip += member.name;
    zip += compression == NpzCompression::deflated ? packed : file;
    if (zip.size() > most_bytes) refuse();
    put(directory, 0x02014b50, 4);
    put(directory, version_needed, 2);  // made by
    put_member(directory, member);
    put(directory, 0, 2);  // comment
    put(directory, 0, 2);  // disk
    put(directory, 0, 2);  // internal attributes
    put(directory, 0, 4);  // external attributes
    put(directory, start, 4);
    directory += member.name;
  }
  const std::size_t start = zip.size();
  zip += directory;
  if (zip.size() > most_bytes || arrays.size() > 0xFFFF) refuse();
  put(zip, 0x06054b50, 4);
  put(zip, 0, 4);  // disks
  put(zip, arrays.size(), 2);
  put(zip, arrays.size(), 2);
  put(zip, directory.size(), 4);
  put(zip, start, 4);
  put(zip, 0, 2);  // comment
  return zip;
}

}  // namespace mien::motion
