#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace mien::pipeline {

/// Line and column of a byte, both from 1; columns count characters, not bytes.
struct TextPosition {
  int line = 1;
  int column = 1;
};

/// The position of the first byte that is not valid UTF-8; overlong forms, surrogates and zero
/// bytes count as invalid.
std::optional<TextPosition> first_invalid_utf8(std::string_view text);

/// Number of characters in valid UTF-8.
std::size_t count_characters(std::string_view text);

}  // namespace mien::pipeline
