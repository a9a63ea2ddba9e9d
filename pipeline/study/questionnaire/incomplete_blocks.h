#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mien::pipeline {

/// An incomplete block design: assigns `treatments` to blocks of `size` each (a participant's
/// share), block by block, so that after every block
///
/// - the numbers of blocks of any two treatments differ by at most one, and
/// - the numbers of blocks that contain any two treatments together are as equal as a search by
/// exchanges finds.
///
/// Where treatments are of several kinds, each block has as equal numbers of every kind as that
/// allows. `kinds` are the kinds of each treatment, numbered from 0 (an actor, an emotion); empty
/// for none.
///
/// Block i depends on seed and i alone: further blocks do not change earlier ones. Treatments
/// within a block are in increasing order.
std::vector<std::vector<std::size_t>> incomplete_blocks(
    std::size_t treatments, std::size_t size, std::size_t blocks, std::uint64_t seed,
    const std::vector<std::vector<std::size_t>>& kinds = {});

}  // namespace mien::pipeline
