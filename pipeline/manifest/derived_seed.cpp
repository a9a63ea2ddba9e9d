#include "pipeline/manifest/derived_seed.h"

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

std::uint64_t derived_seed(std::uint64_t study_seed, std::string_view name) {
  constexpr double seeds = 9007199254740992.0;  // 2⁵³: what a double counts
  return static_cast<std::uint64_t>(seeds * uniform(study_seed, name));
}

}  // namespace mien::pipeline
