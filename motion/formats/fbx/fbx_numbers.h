#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/formats/fbx/fbx_document.h"

namespace mien::motion {

/// All numbers of a node: its array, inflated, or its list of values. The whole numbers have the
/// type int64, the others double; those of the file are converted. Throws mien::Error if they are
/// no numbers, if an array is damaged, or if there are more or fewer than stated.
std::vector<double> doubles_of(const FbxDocument& document, std::uint32_t node);
std::vector<float> floats_of(const FbxDocument& document, std::uint32_t node);
std::vector<std::int64_t> integers_of(const FbxDocument& document, std::uint32_t node);

/// How many numbers a node of a binary file states; 0 for text files. Inflates nothing.
std::size_t stated_numbers_of(const FbxDocument& document, std::uint32_t node);

}  // namespace mien::motion
