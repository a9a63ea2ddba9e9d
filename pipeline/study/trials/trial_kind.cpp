#include "pipeline/study/trials/trial_kind.h"

#include <algorithm>
#include <cassert>

namespace mien::pipeline {

constinit const TrialKind matching_trials = {.name = "matching"};

std::string_view Trial::kind_name() const {
  return is_attention_check() ? attention_kind : kind->name;
}

const TrialKind& trial_kind_of(const TrialForm& form) {
  const auto found =
      std::ranges::find(trial_kinds, &form, [](const auto* kind) { return kind->form; });
  assert(found != trial_kinds.end());
  return **found;
}

std::string choice_fault(const GivenResponse& response, const std::vector<std::string>& choices) {
  const bool is_chosen =
      !response.is_number && std::ranges::find(choices, response.value_raw) != choices.end();
  return is_chosen ? "" : "an answer is none of those that may be chosen";
}

}  // namespace mien::pipeline
