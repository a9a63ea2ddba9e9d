#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mien::motion {

/// Damerau–Levenshtein distance: the fewest insertions, deletions, replacements and exchanges of
/// neighbouring letters that turn one word into the other. Counts bytes; case-sensitive.
int edit_distance(std::string_view from, std::string_view to);

/// The candidate that was most likely meant by `word`; empty if there is none.
///
/// A candidate is near if it differs by at most one edit per three letters (but at least one is
/// allowed), ignoring case; a hyphenated word is also compared with its halves exchanged
/// ("happy-sad"). Of equally near candidates the first is taken. If none is near, a candidate is
/// returned if it is the only one that continues `word` with a hyphen or an underscore ("limit_s"
/// for "limit"). Empty for words over 200 bytes.
std::optional<std::string> nearest_word(std::string_view word,
                                        std::span<const std::string> candidates);

/// `did you mean "quickness"?` when a candidate is near `word`, and otherwise the list of
/// candidates, truncated after twelve: `use one of "quickness", "clearness"`. For the remedy of an
/// Error.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace mien::motion
