#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/stimulus.h"
#include "scenes/stage/layout.h"

namespace mien::pipeline {

/// A sheet about two motions, a gallery of several, or pictures of several stimuli.
struct Sheet {
  std::string path;       ///< in the manifest: "sheets[0]"
  std::string id;         ///< file name; "<target>_<created>", "gallery" or "stills" unless given
  std::string target;     ///< stimulus or example
  std::string created;    ///< stimulus or example
  std::string reference;  ///< stimulus or example; empty for none
  /// Stimuli or examples, one a row, the first being what the others are measured against; then
  /// there is no target. Empty for others.
  std::vector<std::string> gallery;
  std::vector<std::string> stills;  ///< stimuli, a picture each; empty for others
  int columns = 6;                  ///< of pictures
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
    {"superimposed", scenes::Layout::superimposed}, {"side-by-side", scenes::Layout::side_by_side}};

/// Motions together on one stage.
struct Overlay {
  /// What it is called and how it is filmed (path "overlays[0]"); it has no motion of its own.
  Stimulus film;
  std::string target;     ///< stimulus or example
  std::string created;    ///< stimulus or example
  std::string reference;  ///< stimulus or example; empty for none
  scenes::Layout layout = scenes::Layout::superimposed;
  double opacity = 0.75;  ///< of figures in the same place; those side by side are opaque
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

/// What each figure of an overlay stands for, and its motion.
std::vector<std::pair<Role, std::string>> motions_on(const Overlay& overlay);

/// All motions on a sheet.
std::vector<std::string> motions_on(const Sheet& sheet);

/// Two motions whose distance a sheet shows.
struct MotionPair {
  std::string target;
  std::string created;
};

/// A comparison's one; a gallery's first motion with each other; none of pictures.
std::vector<MotionPair> pairs_on(const Sheet& sheet);

}  // namespace mien::pipeline
