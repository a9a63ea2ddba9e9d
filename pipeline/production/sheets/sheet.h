#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/measures/distance/distance.h"
#include "motion/skeleton/example.h"
#include "pipeline/production/synthesis/parameter_label.h"

namespace mien::pipeline {

/// One of the motions on a comparison or gallery sheet. Texts are UTF-8 and shown unchanged.
struct SheetMotion {
  std::string id;      ///< id of the stimulus or example: "guess-1"
  std::string origin;  ///< source of the motion: "from adjectives", "example", "as captured"
  motion::Example motion;
  /// Example → weight, for weights above 0; empty if it is not a blend.
  std::vector<std::pair<std::string, double>> weights;
};

/// The requested, held and reached value of a parameter of a motion: 0 low, 1 high. Unset: not
/// requested, not held, or unknown.
struct SheetValue {
  std::optional<double> requested;
  std::optional<double> held;
  std::optional<double> reached;
};

/// A parameter and its values in both motions.
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
  std::optional<SheetMotion> reference;  ///< shown, not measured
  motion::Distance distance;             ///< between target and created
  /// Requested parameters first, then the held ones, then all other rated ones.
  std::vector<SheetParameter> parameters;
  bool simulated_ratings = false;
  /// Of parameters and joints, and of headings; not NameLanguage::study.
  NameLanguage names = NameLanguage::english;
  std::vector<std::pair<std::string, std::string>> provenance;  ///< ("seed", "7"), …
};

/// Returns "Below the matching threshold: D = 0.043 m < 0.06 m", or "Not below" with "≥".
/// Numbers have as many digits as the printed comparison needs to be true.
std::string verdict(const motion::Distance& distance);

/// Returns the joint whose mean distance over time is the largest: "largest mean distance: left
/// wrist, 0.132 m".
std::string largest_distance_text(const motion::Distance& distance);

/// Returns "durations: target 2.07 s, created 1.40 s (-0.67 s)".
std::string durations_text(const motion::Example& target, const motion::Example& created);

/// Returns "fingertips 0.034 m apart", seen from the wrists (motion/measures/distance); empty
/// unless both motions have fingers.
std::string fingertips_text(const motion::Example& target, const motion::Example& created);

/// Returns largest_distance_text, durations_text and fingertips_text in one line: differences that
/// the mean distance may hide, or does not contain.
std::string beside_verdict(const motion::Distance& distance, const motion::Example& target,
                           const motion::Example& created);

/// Return the sheet as one A3 landscape page: a PDF (vector), or a PNG of the same page, 3508
/// pixels wide. The same content gives the same bytes. Throws mien::Error if no font has Japanese
/// characters.
std::string sheet_as_pdf(const SheetContent& content);
std::string sheet_as_png(const SheetContent& content);

}  // namespace mien::pipeline
