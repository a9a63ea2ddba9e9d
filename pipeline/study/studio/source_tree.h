#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "motion/error.h"

namespace mien::pipeline {

/// A YAML value as it stands in a file, aliases and merge keys left as they are written. Positions
/// are bytes of the file.
struct SourceNode {
  enum class Kind { null, scalar, sequence, map, alias };

  Kind kind = Kind::null;
  bool is_flow = false;          ///< of a collection: in brackets
  std::size_t begin = 0;         ///< its anchor or tag, or its first byte
  std::size_t content = 0;       ///< its first byte
  std::size_t end = 0;           ///< behind its last byte, comments apart
  std::size_t column = 0;        ///< of a block collection: bytes before its keys or dashes
  std::string text;              ///< of a scalar, as read
  Place place;                   ///< of `begin`
  int used_again = 0;            ///< line of an alias that names it; 0: none does
  std::size_t anchor = 0;        ///< its own, or that which an alias names; 0: none
  std::vector<SourceNode> keys;  ///< of a map
  std::vector<SourceNode> children;
};

/// The one document of a file. Throws Faults as read_yaml finds them.
SourceNode read_source(std::string_view text, const std::string& file);

/// Behind the last byte of the line that a byte is on, its line break apart.
std::size_t end_of_line(std::string_view text, std::size_t at);
std::size_t begin_of_line(std::string_view text, std::size_t at);

}  // namespace mien::pipeline
