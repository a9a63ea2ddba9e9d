#pragma once

#include <string>

#include <zlib.h>

namespace mien::test {

/// The bytes as a gzip file.
inline std::string gzipped(const std::string& bytes) {
  constexpr int window_with_gzip_header = 15 + 16;
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, window_with_gzip_header, 8, Z_DEFAULT_STRATEGY);
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

}  // namespace mien::test
