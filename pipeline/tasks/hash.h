#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// 128-bit content hash (XXH3), 32 hexadecimal digits.
using Hash = std::string;

Hash hash_of(std::string_view bytes);

/// Hash of a file's content. Throws Error for a pipe, a device or the like, and std::system_error
/// if the file cannot be read.
Hash hash_of_file(const std::filesystem::path& file);

/// Builds an artifact's key from named values: all its determinants. As long as the key stays the
/// same, the artifact is not produced again. The key depends on the order of the values and on the
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
