#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace mien::motion {

// Untrusted text (a file, a request, the name of a file) for messages. Terminal control and
// characters that hide or reorder text are escaped: a control character as
// "\n" or "\x1b", one beyond ASCII as "\u202e", a byte that is not UTF-8 as "\xff".

/// Largest number of characters of such a text in a message, including the "…" of a cut.
inline constexpr std::size_t max_quoted_characters = 80;

/// Largest number of entries in a message.
inline constexpr std::size_t max_listed_names = 12;

enum class LineEnds { escaped, kept };

/// The whole text. With LineEnds::kept, line feeds and tabs stay as they are. Harmless text comes
/// back as it is.
std::string printable(std::string_view text, LineEnds line_ends = LineEnds::escaped);

/// At most `most` characters of the text, cut between characters with "…". Looks at no more of a
/// long text than it shows.
std::string excerpt(std::string_view text, std::size_t most = max_quoted_characters,
                    LineEnds line_ends = LineEnds::escaped);

/// The excerpt in double quotes.
std::string in_quotes(std::string_view text);

/// The first of many names, and how many more there are: "a, b, c and 9 more".
std::string first_of(std::span<const std::string> names, std::size_t most,
                     std::string_view between = ", ");

/// Names one after the other, an excerpt of each: "a, b, c"; after twelve, ", … (40 in all)".
std::string listed(std::span<const std::string> names);

}  // namespace mien::motion
