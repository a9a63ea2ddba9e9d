#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "motion/error.h"

namespace mien::pipeline {

/// Source locations of a document's values by path: "stimuli[2].adjectives.quickness".
struct Places {
  std::map<std::string, Place> values;
  std::map<std::string, Place> keys;  ///< locations of the keys of map members
};

/// "stimuli[2]" + "look" = "stimuli[2].look"; "" + "look" = "look".
std::string member_path(const std::string& path, std::string_view key);

/// "stimuli" + 2 = "stimuli[2]".
std::string element_path(const std::string& path, std::size_t index);

/// The location of a value or, if the document does not contain it, of the nearest enclosing one.
Place place_of(const Places& places, std::string path);

/// The location of a member's key or, if the document does not contain the key, place_of(path).
Place key_place_of(const Places& places, const std::string& path);

}  // namespace mien::pipeline
