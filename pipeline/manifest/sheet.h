#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/stimulus.h"
#include "scenes/stage/layout.h"

namespace mien::pipeline {

/// A sheet that compares two motions, a gallery of several motions, or stills of several stimuli.
struct Sheet {
  std::string path;       ///< path in the manifest: "sheets[0]"
  std::string id;         ///< file stem; by default "<target>_<created>", "gallery" or "stills"
  std::string target;     ///< stimulus or example
  std::string created;    ///< stimulus or example
  std::string reference;  ///< stimulus or example; empty for none
  /// Ids of stimuli or examples of a gallery, one per row; distances are measured from the first,
  /// and `target` is empty. Other sheets have no ids here.
  std::vector<std::string> gallery;
  std::vector<std::string> stills;  ///< stimulus ids, one picture each; empty for other sheets
  int columns = 6;                  ///< number of pictures per row of a sheet of stills
};

void fields_of(auto&& field, MaybeConst<Sheet> auto& sheet) {
  field("id", sheet.id, concerns::page);
  field.group("compare", [&](auto& compare) {
    compare("target", sheet.target, concerns::page);
    compare("created", sheet.created, concerns::page);
    compare("reference", sheet.reference, concerns::page);
  });
  field("gallery", sheet.gallery, concerns::page);
  field("stills", sheet.stills, concerns::page);
  field("columns", sheet.columns, concerns::page);
}

inline constexpr Words<scenes::Layout> layout_words = {
    {"superimposed", scenes::Layout::superimposed},
    {"side-by-side", scenes::Layout::side_by_side},
    {"as-recorded", scenes::Layout::as_recorded}};

/// Several motions on one stage.
struct Overlay {
  /// The id, look and output of the overlay (path "overlays[0]"); it has no motion of its own.
  Stimulus film;
  std::string target;     ///< stimulus or example
  std::string created;    ///< stimulus or example
  std::string reference;  ///< stimulus or example; empty for none
  scenes::Layout layout = scenes::Layout::superimposed;
  double opacity = 0.75;  ///< of superimposed figures; others are opaque
};

void fields_of(auto&& field, MaybeConst<Overlay> auto& overlay) {
  field("id", overlay.film.id, concerns::picture);
  field("target", overlay.target, concerns::picture | concerns::required);
  field("created", overlay.created, concerns::picture | concerns::required);
  field("reference", overlay.reference, concerns::picture);
  field("layout", overlay.layout, concerns::picture, layout_words);
  field("opacity", overlay.opacity, concerns::picture);
  field("look", overlay.film.look, concerns::picture);
  field("output", overlay.film.output, concerns::nothing);
}

/// Returns the role of each figure of an overlay and the id of its motion.
std::vector<std::pair<Role, std::string>> motions_on(const Overlay& overlay);

/// Returns the ids of all motions on a sheet.
std::vector<std::string> motions_on(const Sheet& sheet);

/// Two motions whose distance a sheet shows.
struct MotionPair {
  std::string target;
  std::string created;
};

/// Returns the pair of a comparison, the pairs of a gallery's first motion with each of the others,
/// or none for stills.
std::vector<MotionPair> pairs_on(const Sheet& sheet);

}  // namespace mien::pipeline
