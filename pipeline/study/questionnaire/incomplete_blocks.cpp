#include "pipeline/study/questionnaire/incomplete_blocks.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string>
#include <tuple>

#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {

namespace {

using Treatments = std::vector<std::size_t>;

class BlockDesign {
 public:
  BlockDesign(std::size_t treatments, std::size_t size, std::uint64_t seed,
              const std::vector<Treatments>& kinds)
      : treatments_(treatments),
        size_(size),
        seed_(seed),
        kinds_(kinds),
        replications_(treatments),
        concurrences_(treatments * treatments) {
    kinds_.resize(treatments);
    for (const Treatments& own : kinds_) {
      for (const std::size_t kind : own) {
        if (kind >= of_kind_.size()) of_kind_.resize(kind + 1);
        ++of_kind_[kind];
      }
    }
  }

  Treatments next() {
    Treatments chosen = first_choice();
    improve(chosen);
    for (const std::size_t a : chosen) {
      ++replications_[a];
      for (const std::size_t b : chosen)
        if (a != b) ++concurrences_[a * treatments_ + b];
    }
    ++block_;
    std::ranges::sort(chosen);
    return chosen;
  }

 private:
  /// The increase of the sum of squared pair counts when the treatment joins the chosen ones.
  long long cost(std::size_t treatment, const Treatments& chosen) const {
    long long sum = 0;
    for (const std::size_t other : chosen)
      if (other != treatment) sum += 2 * concurrences_[treatment * treatments_ + other] + 1;
    return sum;
  }

  /// The largest share of one of its kinds in a block with the treatment.
  double fullness(std::size_t treatment, const std::vector<std::size_t>& chosen_of_kind) const {
    double most = 0.0;
    for (const std::size_t kind : kinds_[treatment])
      most = std::max(most, static_cast<double>(chosen_of_kind[kind] + 1) /
                                static_cast<double>(of_kind_[kind]));
    return most;
  }

  /// Chooses greedily: the treatment assigned least often, then of the kinds that are scarcest in
  /// the block, then least often together with those chosen; ties are broken at random.
  Treatments first_choice() const {
    const Treatments order = random_order(treatments_, seed_, "block/" + std::to_string(block_));
    Treatments chosen;
    std::vector<bool> is_in(treatments_);
    std::vector<std::size_t> chosen_of_kind(of_kind_.size());
    while (chosen.size() < size_) {
      std::size_t best = treatments_;
      std::tuple<int, double, long long> least;
      for (const std::size_t treatment : order) {
        if (is_in[treatment] ||
            (best != treatments_ && replications_[treatment] > std::get<0>(least)))
          continue;
        const std::tuple own{replications_[treatment], fullness(treatment, chosen_of_kind),
                             cost(treatment, chosen)};
        if (best != treatments_ && own >= least) continue;
        best = treatment;
        least = own;
      }
      is_in[best] = true;
      chosen.push_back(best);
      for (const std::size_t kind : kinds_[best]) ++chosen_of_kind[kind];
    }
    return chosen;
  }

  /// Exchanges treatments of the same kinds and equal counts while that makes pair counts more
  /// even.
  void improve(Treatments& chosen) const {
    const Treatments order = random_order(treatments_, seed_, "exchange/" + std::to_string(block_));
    std::vector<bool> is_in(treatments_);
    for (const std::size_t treatment : chosen) is_in[treatment] = true;
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (std::size_t& out : chosen) {
        for (const std::size_t in : order) {
          if (is_in[in] || replications_[in] != replications_[out] || kinds_[in] != kinds_[out])
            continue;
          if (cost(in, chosen) - 2 * concurrences_[in * treatments_ + out] - 1 >= cost(out, chosen))
            continue;
          is_in[out] = false;
          is_in[in] = true;
          out = in;
          is_better = true;
        }
      }
    }
  }

  std::size_t treatments_;
  std::size_t size_;
  std::uint64_t seed_;
  std::vector<Treatments> kinds_;
  std::vector<std::size_t> of_kind_;  ///< number of treatments of each kind
  std::size_t block_ = 0;
  std::vector<int> replications_;
  std::vector<std::uint16_t>
      concurrences_;  ///< treatments × treatments; large where there are thousands
};

}  // namespace

std::vector<Treatments> incomplete_blocks(std::size_t treatments, std::size_t size,
                                          std::size_t blocks, std::uint64_t seed,
                                          const std::vector<Treatments>& kinds) {
  assert(size <= treatments);
  if (size == treatments) {
    Treatments all(treatments);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return std::vector<Treatments>(blocks, all);
  }
  BlockDesign design(treatments, size, seed, kinds);
  std::vector<Treatments> dealt;
  for (std::size_t i = 0; i < blocks; ++i) dealt.push_back(design.next());
  return dealt;
}

}  // namespace mien::pipeline
