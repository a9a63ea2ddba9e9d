#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/text/words.h"
#include "pipeline/base/documents/concerns.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

struct Manifest;

/// What of a modified motion a foil leaves as it was before.
enum class FoilAspect { posture, path_length, speed, acceleration };

inline constexpr Words<FoilAspect> foil_aspect_words = {{"posture", FoilAspect::posture},
                                                        {"path-length", FoilAspect::path_length},
                                                        {"speed", FoilAspect::speed},
                                                        {"acceleration", FoilAspect::acceleration}};

inline std::string_view name_of(FoilAspect aspect) { return word_of(foil_aspect_words, aspect); }

/// Another stimulus with all of its modifications but one aspect, so that the two differ in that
/// alone.
struct Foil {
  std::string of;  ///< id of the stimulus
  FoilAspect differ = FoilAspect::posture;

  friend bool operator==(const Foil&, const Foil&) = default;
};

void fields_of(auto&& field, MaybeConst<Foil> auto& foil) {
  field("of", foil.of, concerns::motion | concerns::required);
  field("differ", foil.differ, concerns::motion | concerns::required, foil_aspect_words);
}

/// Gives every foil the motion of the stimulus that it is of, and that stimulus's modifications
/// without the aspect. Their own recipes must have been resolved. Faults: a stimulus that is not
/// there or is a foil itself, and one whose modifications have nothing of the aspect.
std::vector<Fault> resolve_foils(Manifest& manifest);

}  // namespace mien::pipeline
