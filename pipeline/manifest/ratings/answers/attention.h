#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"

namespace mien::pipeline {

/// Whose answers are left out for want of attention.
struct AttentionRule {
  int most_failed = 1;  ///< who fails more checks is left out: one may be missed by an oversight
};

/// How a participant did.
struct Attention {
  std::string participant;
  int checks = 0;  ///< those with an expected answer that were answered
  int passed = 0;
  bool is_excluded = false;
};

/// Of every participant, in the order of the rows. Without checks nobody is excluded.
std::vector<Attention> attention_of(const std::vector<AnswerRow>& rows,
                                    const AttentionRule& rule = {});

/// The rule in a plain sentence.
std::string to_sentence(const AttentionRule& rule);

}  // namespace mien::pipeline
