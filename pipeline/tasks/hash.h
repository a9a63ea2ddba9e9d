#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// 128-bit content hash (XXH3), 32 hexadecimal digits.
using Hash = std::string;

Hash hash_of(std::string_view bytes);

/// Throws Error for a pipe, a device or the like, and std::system_error when the file cannot be
/// read.
Hash hash_of_file(const std::filesystem::path& file);

/// Builds an artifact's key out of named values: everything that determines it. While the key stays
/// the same the artifact is not made again. The order of the values counts, and so do the
/// boundaries between them.
class KeyBuilder {
 public:
  KeyBuilder& add(std::string_view name, std::string_view value);
  KeyBuilder& add(std::string_view name, double value);
  KeyBuilder& add(std::string_view name, std::int64_t value);

  Hash key() const;

 private:
  std::string determinants_;
};

}  // namespace mien::pipeline
