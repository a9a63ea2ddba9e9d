#pragma once

#include <string>
#include <string_view>

namespace mien::motion {

/// A text as one word of a POSIX shell, always in quotes: 'it'\''s'.
std::string in_single_quotes(std::string_view text);

/// A text as one word of a POSIX shell command that is suggested in a message: unquoted if
/// possible, else in single quotes. A text with characters that `printable` escapes (excerpt.h) is
/// written as $'…', which sh (POSIX 2024), bash and zsh understand, so that it can be displayed and
/// copied.
std::string shell_word(std::string_view text);

/// Like shell_word, for a path: if it begins with '-', it gets the prefix "./" so that it is not
/// read as an option.
std::string shell_path(std::string_view path);

}  // namespace mien::motion
