#pragma once

#include <string>
#include <string_view>

namespace mien::motion {

/// A text as one word of a POSIX shell, in quotes even where it needs none: 'it'\''s'.
std::string in_single_quotes(std::string_view text);

/// A text as one word of a command that a message proposes, for a POSIX shell: as it is where it
/// may stand so, else in single quotes. One with control characters is written as $'…', which sh
/// (POSIX 2024), bash and zsh read, so that it can be shown and copied.
std::string shell_word(std::string_view text);

/// As shell_word, for a path: one that begins with '-' would be read as an option and gets the
/// prefix "./".
std::string shell_path(std::string_view path);

}  // namespace mien::motion
