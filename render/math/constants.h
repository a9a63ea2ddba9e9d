#pragma once

#include <limits>
#include <numbers>

namespace mien::render {

inline constexpr float pi = std::numbers::pi_v<float>;
inline constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace mien::render
