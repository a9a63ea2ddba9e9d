#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace mien::motion {

// Text that somebody else wrote (a file, a request, the name of a file) as a message shows it. What
// a terminal would obey, or what hides or reorders text, is written out: a control character as
// "\n" or "\x1b", one beyond ASCII as "\u202e", a byte that is not UTF-8 as "\xff".

/// Most characters that a message shows of one such text, the "…" of a cut included.
inline constexpr std::size_t most_quoted = 80;

/// Most entries that a message lists.
inline constexpr std::size_t most_listed = 12;

enum class LineEnds { escaped, kept };

/// The whole text. With LineEnds::kept, line feeds and tabs stay as they are. Harmless text comes
/// back as it is.
std::string printable(std::string_view text, LineEnds line_ends = LineEnds::escaped);

/// At most `most` characters of the text, cut between characters with "…". Looks at no more of a
/// long text than it shows.
std::string excerpt(std::string_view text, std::size_t most = most_quoted,
                    LineEnds line_ends = LineEnds::escaped);

/// The excerpt in double quotes.
std::string in_quotes(std::string_view text);

/// The first of many names, and how many more there are: "a, b, c and 9 more".
std::string first_of(std::span<const std::string> names, std::size_t most,
                     std::string_view between = ", ");

/// Names one after the other, an excerpt of each: "a, b, c"; after twelve, ", … (40 in all)".
std::string listed(std::span<const std::string> names);

}  // namespace mien::motion
