#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

struct Manifest;
struct Stimulus;

/// Rated parameters that a stimulus does not request and that should keep their values as closely
/// as the examples allow.
struct Hold {
  /// Hold all parameters that are not requested, of the same kind (groups or scales) as the
  /// requested ones.
  bool others = false;
  std::vector<std::string> names;  ///< hold only these parameters
  /// Hold these parameters at given values, 0…1.
  std::vector<std::pair<std::string, double>> values;
  /// The stimulus whose values the parameters of `others` and `names` keep: the first blended one
  /// with the role of a reference. If empty, these parameters are held at the mean of the examples.
  /// (A vector of at most one element, because a Stimulus contains a Hold.)
  std::vector<Stimulus> reference;

  bool anything() const { return others || !names.empty() || !values.empty(); }
};

/// `hold:`: "others", names, or a map of names to values.
struct HoldForm {
  static void read(const DocumentValue& given, Hold& hold);
  static nlohmann::ordered_json write(const Hold& hold, const WritingOptions& how);
};

/// Sets the reference of each hold. Foils must have been resolved (foil.h).
void resolve_holds(Manifest& manifest);

}  // namespace mien::pipeline
