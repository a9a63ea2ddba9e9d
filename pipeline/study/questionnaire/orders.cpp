#include "pipeline/study/questionnaire/orders.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "motion/math/random_number.h"

namespace mien::pipeline {

std::uint64_t hashed_seed(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = motion::random_bits(seed, 0);
  for (const unsigned char letter : name) hash = motion::random_bits(hash ^ letter, 1);
  return hash;
}

std::size_t random_choice(std::size_t count, std::uint64_t seed, std::string_view name,
                          std::uint64_t index) {
  assert(count > 0);
  // The high part of the product (Lemire 2019); its bias is below 2⁻³².
  const std::uint64_t bits = motion::random_bits(hashed_seed(seed, name), index) >> 32U;
  return static_cast<std::size_t>((bits * count) >> 32U);
}

std::vector<std::size_t> random_order(std::size_t count, std::uint64_t seed,
                                      std::string_view name) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Fisher and Yates 1938, from the end.
  for (std::size_t left = count; left > 1; --left)
    std::swap(order[left - 1], order[random_choice(left, seed, name, left)]);
  return order;
}

std::vector<std::size_t> places_of_checks(std::size_t trials, std::size_t every, std::uint64_t seed,
                                          std::string_view name) {
  std::vector<std::size_t> places;
  if (every == 0) return places;
  const std::size_t reach = every / 4;
  for (std::size_t after = every; after < trials; after += every) {
    const std::size_t moved = after - reach + random_choice(2 * reach + 1, seed, name, after);
    if (moved < trials) places.push_back(moved - 1);
  }
  return places;
}

std::size_t williams_rows(std::size_t count) { return count % 2 == 0 ? count : 2 * count; }

std::vector<std::size_t> williams_row(std::size_t count, std::size_t row) {
  std::vector<std::size_t> order(count);
  if (count == 0) return order;
  row %= williams_rows(count);
  // 0, 1, n − 1, 2, n − 2 …: neighbours differ by every number once.
  for (std::size_t place = 0; place < count; ++place) {
    const std::size_t first = place % 2 == 1 ? (place + 1) / 2 : (count - place / 2) % count;
    order[place] = (first + row) % count;
  }
  if (row >= count) std::ranges::reverse(order);
  return order;
}

}  // namespace mien::pipeline
