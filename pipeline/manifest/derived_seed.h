#pragma once

#include <cstdint>
#include <string_view>

namespace mien::pipeline {

/// Returns the seed of the named part of a study: a hash of the study's seed and the name.
std::uint64_t derived_seed(std::uint64_t study_seed, std::string_view name);

}  // namespace mien::pipeline
