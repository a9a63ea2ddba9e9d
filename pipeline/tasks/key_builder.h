#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

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
