#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// A uniformly random permutation of 0 … count − 1, deterministic in seed and name.
std::vector<std::size_t> random_order(std::size_t count, std::uint64_t seed, std::string_view name);

/// A uniformly random number from 0 to count − 1, deterministic in seed, name and index. `count`
/// must not be 0.
std::size_t random_choice(std::size_t count, std::uint64_t seed, std::string_view name,
                          std::uint64_t index = 0);

/// The places, from 0, of the trials that attention checks follow: one after every `every` trials,
/// moved back or forward at random by up to a quarter of that, none after the last. None at all if
/// `every` is 0.
std::vector<std::size_t> places_of_checks(std::size_t trials, std::size_t every, std::uint64_t seed,
                                          std::string_view name);

/// A derived seed for a named random decision: a hash of the seed and the name.
std::uint64_t hashed_seed(std::uint64_t seed, std::string_view name);

/// A row of Williams' Latin square of 0 … count − 1 (Williams 1949), balanced for carry-over. In
/// the first `count` rows, each number occurs once in each position. For an even count, every
/// number follows every other once in these rows; for an odd count, twice in 2·count rows: those
/// from `count` on are the first `count` rows, each in reverse order. `row` may be any number; rows
/// repeat cyclically.
std::vector<std::size_t> williams_row(std::size_t count, std::size_t row);

/// The number of rows in which every number follows every other equally often: `count` if even,
/// otherwise 2·`count`.
std::size_t williams_rows(std::size_t count);

}  // namespace mien::pipeline
