#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

/// A YAML value and where it was written. Aliases are resolved and merge keys (`<<`) merged.
struct YamlNode {
  enum class Kind { null, scalar, sequence, map };

  Kind kind = Kind::null;
  std::string text;     ///< text of a scalar
  bool quoted = false;  ///< a quoted scalar, which is always text
  Place place;
  std::vector<YamlNode> keys;  ///< keys of a map: scalars, each occurring once
  /// Elements of a sequence, or values of a map, in the order of `keys`.
  std::vector<YamlNode> children;
};

/// Reads one YAML document. Faults of the text are added to `faults`.
///
/// After some faults the tree is null: an empty file, more than 16 MiB, text that is not UTF-8, a
/// syntax error, a tab in the indentation, an alias that is unknown or inside its own value,
/// nesting deeper than 100, more than 1,000,000 values. In this number, copies for anchors and
/// aliases count, and long texts count several times.
///
/// After other faults the tree contains the rest of the document: a second document, an unclosed
/// quote at the end, an unknown tag, a key that occurs twice, is not a scalar or has more than 200
/// bytes, a `<<` of something other than maps.
YamlNode read_yaml(std::string_view text, const std::string& file, std::vector<Fault>& faults);

}  // namespace mien::pipeline
