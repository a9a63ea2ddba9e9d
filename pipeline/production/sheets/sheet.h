#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/measures/distance/distance.h"
#include "motion/skeleton/example.h"
#include "pipeline/production/synthesis/parameter_label.h"

namespace mien::pipeline {

/// One of the motions on a comparison sheet. Texts are UTF-8 and shown as they are.
struct SheetMotion {
  std::string id;      ///< of the stimulus or example: "guess-1"
  std::string origin;  ///< how it came to be: "from adjectives", "example", "as captured"
  motion::Example motion;
  std::vector<std::pair<std::string, double>> weights;  ///< example → share; empty for no blend
};

/// The requested or held value of a parameter of a motion, and the value reached: shares of its
/// range, 0 low, 1 high. Empty: not requested, not held, or not known.
struct SheetValue {
  std::optional<double> requested;
  std::optional<double> held;
  std::optional<double> reached;
};

/// A parameter of both motions.
struct SheetParameter : ParameterLabel {
  SheetValue target;
  SheetValue created;

  bool is_requested() const { return target.requested || created.requested; }
  bool is_held() const { return target.held || created.held; }
};

/// Everything that a comparison sheet shows.
struct SheetContent {
  std::string study;
  SheetMotion target;
  SheetMotion created;
  std::optional<SheetMotion> reference;    ///< shown, not measured
  motion::Distance distance;               ///< between target and created
  std::vector<SheetParameter> parameters;  ///< the requested ones first, then those held
  bool simulated_ratings = false;
  std::vector<std::pair<std::string, std::string>> provenance;  ///< ("seed", "7"), …
};

/// "Below the adjective paper's threshold: D = 0.043 m < 0.06 m", or "Not below" with "≥". As many
/// digits as the comparison needs to be true as printed.
std::string verdict(const motion::Distance& distance);

/// What the mean may hide: "most: left wrist, 0.132 m · 1.40 s against 2.07 s (+0.67 s)".
std::string beside_verdict(const motion::Distance& distance, const motion::Example& target,
                           const motion::Example& created);

/// The sheet as one A3 landscape page: a PDF (vector), and a PNG of the same page 3508 pixels wide.
/// The same content gives the same bytes. Throws mien::Error when no font has Japanese letters.
std::string sheet_as_pdf(const SheetContent& content);
std::string sheet_as_png(const SheetContent& content);

}  // namespace mien::pipeline
