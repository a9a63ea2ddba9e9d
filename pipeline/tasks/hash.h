#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// 128-bit content hash (XXH3), 32 hexadecimal digits.
using Hash = std::string;

Hash hash_of(std::string_view bytes);

/// Throws std::system_error when the file cannot be read.
Hash hash_of_file(const std::filesystem::path& file);

/// Builds a key out of named values, everything that determines an artifact. Their order counts,
/// and so do the boundaries between them.
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
