#pragma once

#include <cstddef>
#include <string_view>

namespace mien::motion {

/// Whether the brackets and braces of a JSON text nest deeper than `most`. Check this before
/// parsing, because documents are copied, written and destroyed recursively. (The library's parser
/// callback could do this check as well, but takes quadratic time in the length of a list.) Invalid
/// JSON is left to the parser.
bool is_nested_deeper(std::string_view json, std::size_t most);

/// Nesting limit, deeper than any of our documents.
inline constexpr std::size_t max_json_depth = 64;

}  // namespace mien::motion
