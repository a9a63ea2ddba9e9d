#include "pipeline/study/questionnaire/incomplete_blocks.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string>
#include <tuple>

#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {

namespace {

using Things = std::vector<std::size_t>;

class Dealer {
 public:
  Dealer(std::size_t things, std::size_t size, std::uint64_t seed, const std::vector<Things>& kinds)
      : things_(things),
        size_(size),
        seed_(seed),
        kinds_(kinds),
        dealt_(things),
        together_(things * things) {
    kinds_.resize(things);
    for (const Things& own : kinds_) {
      for (const std::size_t kind : own) {
        if (kind >= of_kind_.size()) of_kind_.resize(kind + 1);
        ++of_kind_[kind];
      }
    }
  }

  Things next() {
    Things chosen = first_choice();
    improve(chosen);
    for (const std::size_t a : chosen) {
      ++dealt_[a];
      for (const std::size_t b : chosen)
        if (a != b) ++together_[a * things_ + b];
    }
    ++block_;
    std::ranges::sort(chosen);
    return chosen;
  }

 private:
  /// The increase of the sum of squared pair counts when the thing joins the chosen ones.
  long long cost(std::size_t thing, const Things& chosen) const {
    long long sum = 0;
    for (const std::size_t other : chosen)
      if (other != thing) sum += 2 * together_[thing * things_ + other] + 1;
    return sum;
  }

  /// The largest share of one of its kinds in a block with the thing.
  double fullness(std::size_t thing, const std::vector<std::size_t>& chosen_of_kind) const {
    double most = 0.0;
    for (const std::size_t kind : kinds_[thing])
      most = std::max(most, static_cast<double>(chosen_of_kind[kind] + 1) /
                                static_cast<double>(of_kind_[kind]));
    return most;
  }

  /// Chooses greedily: the thing assigned least often, then of the kinds that are scarcest in the
  /// block, then least often together with those chosen; ties are broken at random.
  Things first_choice() const {
    const Things order = random_order(things_, seed_, "block/" + std::to_string(block_));
    Things chosen;
    std::vector<bool> is_in(things_);
    std::vector<std::size_t> chosen_of_kind(of_kind_.size());
    while (chosen.size() < size_) {
      std::size_t best = things_;
      std::tuple<int, double, long long> least;
      for (const std::size_t thing : order) {
        if (is_in[thing] || (best != things_ && dealt_[thing] > std::get<0>(least))) continue;
        const std::tuple own{dealt_[thing], fullness(thing, chosen_of_kind), cost(thing, chosen)};
        if (best != things_ && own >= least) continue;
        best = thing;
        least = own;
      }
      is_in[best] = true;
      chosen.push_back(best);
      for (const std::size_t kind : kinds_[best]) ++chosen_of_kind[kind];
    }
    return chosen;
  }

  /// Exchanges things of the same kinds and equal counts while that makes pair counts more even.
  void improve(Things& chosen) const {
    const Things order = random_order(things_, seed_, "exchange/" + std::to_string(block_));
    std::vector<bool> is_in(things_);
    for (const std::size_t thing : chosen) is_in[thing] = true;
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (std::size_t& out : chosen) {
        for (const std::size_t in : order) {
          if (is_in[in] || dealt_[in] != dealt_[out] || kinds_[in] != kinds_[out]) continue;
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
  std::vector<Things> kinds_;
  std::vector<std::size_t> of_kind_;  ///< number of things of each kind
  std::size_t block_ = 0;
  std::vector<int> dealt_;
  std::vector<std::uint16_t> together_;  ///< things × things; large where there are thousands
};

}  // namespace

std::vector<Things> deal_blocks(std::size_t things, std::size_t size, std::size_t blocks,
                                std::uint64_t seed, const std::vector<Things>& kinds) {
  assert(size <= things);
  if (size == things) {
    Things all(things);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return std::vector<Things>(blocks, all);
  }
  Dealer dealer(things, size, seed, kinds);
  std::vector<Things> dealt;
  for (std::size_t i = 0; i < blocks; ++i) dealt.push_back(dealer.next());
  return dealt;
}

}  // namespace mien::pipeline
