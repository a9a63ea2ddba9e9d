#include "pipeline/questionnaire/incomplete_blocks.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string>

#include "pipeline/questionnaire/random_order.h"

namespace mien::pipeline {

namespace {

using Things = std::vector<std::size_t>;

class Dealer {
 public:
  Dealer(std::size_t things, std::size_t size, std::uint64_t seed)
      : things_(things), size_(size), seed_(seed), dealt_(things), together_(things * things) {}

  Things next() {
    Things chosen = first_choice();
    improve(chosen);
    for (const std::size_t a : chosen) {
      ++dealt_[a];
      for (const std::size_t b : chosen) together_[a * things_ + b] += a != b;
    }
    ++block_;
    std::ranges::sort(chosen);
    return chosen;
  }

 private:
  /// What joining the chosen ones adds to the sum of squares of how often two were dealt together.
  long long cost(std::size_t thing, const Things& chosen) const {
    long long sum = 0;
    for (const std::size_t other : chosen) {
      if (other != thing) sum += 2 * together_[thing * things_ + other] + 1;
    }
    return sum;
  }

  /// One by one the thing that was dealt least often and least with those before it; among equals
  /// chance decides.
  Things first_choice() const {
    const Things order = random_order(things_, seed_, "block/" + std::to_string(block_));
    Things chosen;
    std::vector<bool> is_in(things_);
    while (chosen.size() < size_) {
      const std::size_t none = things_;
      std::size_t best = none;
      long long least = 0;
      for (const std::size_t thing : order) {
        if (is_in[thing] || (best != none && dealt_[thing] > dealt_[best])) continue;
        const long long own = cost(thing, chosen);
        if (best != none && dealt_[thing] == dealt_[best] && own >= least) continue;
        best = thing;
        least = own;
      }
      is_in[best] = true;
      chosen.push_back(best);
    }
    return chosen;
  }

  /// Exchanges things that were dealt equally often for as long as pairs become more even.
  void improve(Things& chosen) const {
    const Things order = random_order(things_, seed_, "exchange/" + std::to_string(block_));
    std::vector<bool> is_in(things_);
    for (const std::size_t thing : chosen) is_in[thing] = true;
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (std::size_t& out : chosen) {
        for (const std::size_t in : order) {
          if (is_in[in] || dealt_[in] != dealt_[out]) continue;
          if (cost(in, chosen) - 2 * together_[in * things_ + out] - 1 >= cost(out, chosen))
            continue;
          is_in[out] = false;
          is_in[in] = true;
          out = in;
          is_better = true;
        }
      }
    }
  }

  std::size_t things_;
  std::size_t size_;
  std::uint64_t seed_;
  std::size_t block_ = 0;
  std::vector<int> dealt_;
  std::vector<int> together_;  ///< things × things
};

}  // namespace

std::vector<Things> deal_blocks(std::size_t things, std::size_t size, std::size_t blocks,
                                std::uint64_t seed) {
  assert(size <= things);
  if (size == things) {
    Things all(things);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return std::vector<Things>(blocks, all);
  }
  Dealer dealer(things, size, seed);
  std::vector<Things> dealt;
  for (std::size_t i = 0; i < blocks; ++i) dealt.push_back(dealer.next());
  return dealt;
}

}  // namespace mien::pipeline
