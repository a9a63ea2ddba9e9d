#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "render/vector.h"

namespace mien::pipeline {

/// The linear colour of "#rrggbb" (sRGB), which must be well-formed.
render::Color colour_from_hex(const std::string& hex);

/// Takes a colour over from "#rrggbb" or [r, g, b] (linear); what is neither was told by the schema
/// and changes nothing.
void assign(const nlohmann::json* value, render::Color& target);

}  // namespace mien::pipeline
