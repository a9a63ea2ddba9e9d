#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mien::motion {

/// Damerau–Levenshtein distance: the fewest insertions, deletions, replacements and exchanges of
/// neighbouring letters that turn one word into the other. Counts bytes, minds upper and lower
/// case.
int edit_distance(std::string_view from, std::string_view to);

/// The candidate that `word` was most likely meant to be; empty when none is near.
///
/// Near is at most one edit for each three letters (at least one), case aside, also of a hyphenated
/// word with its halves exchanged ("happy-sad"). The first of equally near ones is taken; without
/// any the only one that the word is the first part of ("limit" of "limit_s"). At most 200 bytes.
std::optional<std::string> nearest_word(std::string_view word,
                                        std::span<const std::string> candidates);

/// `did you mean "quickness"?` when a candidate is near `word`, and otherwise the list of what
/// there is, cut after twelve: `use one of "quickness", "clearness"`. For the remedy of an Error.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace mien::motion
