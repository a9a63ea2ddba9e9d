#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace mien::motion {

// Untrusted text (from a file, a request, a file name) for use in messages. Control characters and
// characters that hide or reorder text are escaped: ASCII as "\n" or "\x1b", others as "\u202e",
// bytes that are not UTF-8 as "\xff".

/// Largest number of characters of such a text in a message, including the "…" of a truncated text.
inline constexpr std::size_t max_quoted_characters = 80;

/// Largest number of list entries in a message.
inline constexpr std::size_t max_listed_names = 12;

enum class LineEnds { escaped, kept };

/// Returns the whole text, escaped. With LineEnds::kept, line feeds and tabs are not escaped.
/// Harmless text is returned unchanged.
std::string printable(std::string_view text, LineEnds line_ends = LineEnds::escaped);

/// Returns the text, escaped; if that has more than `most` characters, only its beginning and "…",
/// at most `most` characters in all. Examines no more of a long text than it shows.
std::string excerpt(std::string_view text, std::size_t most = max_quoted_characters,
                    LineEnds line_ends = LineEnds::escaped);

/// The excerpt in double quotes.
std::string in_quotes(std::string_view text);

/// The first of many names, and how many more there are: "a, b, c and 9 more".
std::string first_of(std::span<const std::string> names, std::size_t most,
                     std::string_view between = ", ");

/// A list of names, with an excerpt of each: "a, b, c"; after twelve names it ends with ", … (40 in
/// all)".
std::string listed(std::span<const std::string> names);

}  // namespace mien::motion
