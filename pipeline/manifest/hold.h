#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

struct Manifest;
struct Stimulus;

/// Rated parameters that a stimulus does not ask for and that shall stay where they are, or as near
/// as the examples allow.
struct Hold {
  bool others = false;             ///< all of the same kind, groups or scales, not asked for
  std::vector<std::string> names;  ///< or these
  std::vector<std::pair<std::string, double>> values;  ///< or these, at 0…1
  /// Where `others` and `names` stay: at what this stimulus has, the first with the role of a
  /// reference; without one at the mean of the examples. (A list of one or none, because a stimulus
  /// has a hold itself.)
  std::vector<Stimulus> reference;

  bool anything() const { return others || !names.empty() || !values.empty(); }
};

/// `hold:`: "others", names, or values by name.
struct HoldForm {
  static void read(const DocumentValue& given, Hold& hold);
  static nlohmann::ordered_json write(const Hold& hold, const WritingOptions& how);
};

/// Gives each hold its reference. Foils are resolved before (foil.h).
void resolve_holds(Manifest& manifest);

}  // namespace mien::pipeline
