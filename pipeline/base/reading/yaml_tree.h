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

/// Reads one YAML document. Faults of the text are added to `faults`: not UTF-8, syntax, a tab in
/// the indentation, a second document, a key that occurs twice, a key that is not a scalar, an
/// unknown alias, aliases that unfold to more than 1,000,000 values, nesting deeper than 100, more
/// than 16 MiB. After a fault of syntax the tree is null.
YamlNode read_yaml(std::string_view text, const std::string& file, std::vector<Fault>& faults);

}  // namespace mien::pipeline
