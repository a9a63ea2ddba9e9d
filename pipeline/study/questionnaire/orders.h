#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// 0 … count − 1 in an order that depends on seed and name alone; every order is equally likely.
std::vector<std::size_t> random_order(std::size_t count, std::uint64_t seed, std::string_view name);

/// A number 0 … count − 1 of seed, name and index alone; count must not be 0.
std::size_t random_choice(std::size_t count, std::uint64_t seed, std::string_view name,
                          std::uint64_t index = 0);

/// The seed of somebody's own: of the study's and a name.
std::uint64_t seed_of(std::uint64_t seed, std::string_view name);

/// A row of Williams' Latin square of 0 … count − 1 (Williams 1949), after which all is said that
/// can be said in so few rows: in `count` rows everything comes once in every place. For an even
/// count, everything follows everything else once in these `count` rows; for an odd one twice in
/// 2·count rows, of which the second half are the first in reverse. `row` may be any number: they
/// go round.
std::vector<std::size_t> williams_row(std::size_t count, std::size_t row);

/// Rows after which everything has followed everything else equally often: count, or 2·count.
std::size_t williams_rows(std::size_t count);

}  // namespace mien::pipeline
