#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/adaptive/next_pairs.h"
#include "pipeline/study/adaptive/pair_study.h"

namespace mien::pipeline {

/// A choice of pairs, with what it was made from.
struct PairChoice {
  PairStudy study;
  NextPairs next;

  const std::string& first_of(std::size_t pair) const {
    return study.stimuli[study.pairs[pair].first];
  }
  const std::string& second_of(std::size_t pair) const {
    return study.stimuli[study.pairs[pair].second];
  }
};

/// The chosen pairs, and what is known of the worths of all stimuli.
std::vector<WrittenTable> pair_tables(const PairChoice& choice);

/// What a choice of pairs is printed as: the pairs with what their answers tell, and how well the
/// worths are known now and after them.
std::string pair_report(const PairChoice& choice);

}  // namespace mien::pipeline
