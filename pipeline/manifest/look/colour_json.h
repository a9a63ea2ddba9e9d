#pragma once

#include <nlohmann/json.hpp>

#include "render/math/vector.h"

namespace mien::pipeline {

/// Takes a colour over from "#rrggbb" or [r, g, b] (linear); what is neither was told by the schema
/// and changes nothing.
void assign(const nlohmann::json* value, render::Color& target);

}  // namespace mien::pipeline
