#pragma once

#include <cstdint>
#include <string_view>

namespace mien::pipeline {

/// The seed of something with a name, in a study with that seed.
std::uint64_t own_seed(std::uint64_t study_seed, std::string_view name);

}  // namespace mien::pipeline
