#pragma once

#include <string>

namespace mien::pipeline {

/// Twice an amount of memory in Slurm's notation: "4G" for "2G", "3000M" for "1500"; empty if the
/// text is not an amount.
std::string doubled_memory(const std::string& memory);

/// The larger of two amounts of memory. A text that is not an amount, such as the empty one of a
/// request that leaves the memory to the site, is the smaller one.
std::string larger_memory(const std::string& one, const std::string& other);

}  // namespace mien::pipeline
