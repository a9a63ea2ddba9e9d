#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mien::pipeline {

/// Deals `things` out to blocks of `size` each (a participant's share), one block after the other,
/// so that after every block
///
/// - each thing has been dealt as often as every other, or once more, and
/// - each two things have been dealt together as equally often as a search by exchanges finds.
///
/// Where things are of several kinds, each block has as equal a share of every kind as that allows:
/// `kinds` are those of each thing, as numbers from 0 (of an actor, of an emotion); empty for none.
///
/// Block i depends on seed and i alone: further blocks change none before. Of each, the things in
/// increasing order.
std::vector<std::vector<std::size_t>> deal_blocks(
    std::size_t things, std::size_t size, std::size_t blocks, std::uint64_t seed,
    const std::vector<std::vector<std::size_t>>& kinds = {});

}  // namespace mien::pipeline
