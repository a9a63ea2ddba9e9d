#pragma once

#include <cstddef>
#include <string_view>

namespace mien::motion {

/// Whether the brackets and braces of a JSON text nest deeper than that. To be asked before it is
/// parsed: what is made of it is copied, written and taken apart by functions that call themselves.
/// (A parser with a callback could tell too, but the library's then takes the square of a list's
/// length.) Text that is no JSON is left to the parser.
bool is_nested_deeper(std::string_view json, std::size_t most);

/// Deeper than any document of ours is.
inline constexpr std::size_t deepest_document = 64;

}  // namespace mien::motion
