#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/text/words.h"
#include "pipeline/base/documents/concerns.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

struct Manifest;

/// The aspect of a modified motion that a foil leaves unmodified.
enum class FoilAspect { posture, path_length, speed, acceleration };

inline constexpr Words<FoilAspect> foil_aspect_words = {{"posture", FoilAspect::posture},
                                                        {"path-length", FoilAspect::path_length},
                                                        {"speed", FoilAspect::speed},
                                                        {"acceleration", FoilAspect::acceleration}};

inline std::string_view name_of(FoilAspect aspect) { return word_of(foil_aspect_words, aspect); }

/// A stimulus with all modifications of another stimulus except one aspect, so that the two differ
/// only in that aspect.
struct Foil {
  std::string of;  ///< id of the original stimulus
  FoilAspect differ = FoilAspect::posture;

  friend bool operator==(const Foil&, const Foil&) = default;
};

void fields_of(auto&& field, MaybeConst<Foil> auto& foil) {
  field("of", foil.of, concerns::motion | concerns::required);
  field("differ", foil.differ, concerns::motion | concerns::required, foil_aspect_words);
}

/// Gives each foil the motion of its original stimulus and that stimulus's modifications without
/// the aspect. The recipes of the modifications must have been resolved. Returns faults if the
/// original does not exist, is itself a foil, is modified by an older method (StyleStep), or is not
/// modified in that aspect, and if the foil states settings that it inherits.
std::vector<Fault> resolve_foils(Manifest& manifest);

}  // namespace mien::pipeline
