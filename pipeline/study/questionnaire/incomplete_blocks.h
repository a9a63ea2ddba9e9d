#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mien::pipeline {

/// An incomplete block design: assigns treatments, numbered from 0 to `treatments` − 1, to blocks
/// of `size` treatments (a block is a participant's share), block by block, so that after every
/// block
///
/// - the numbers of occurrences of the treatments differ by at most one, and
/// - the numbers of blocks shared by two treatments are as equal over all pairs of treatments as a
///   search by exchanges achieves.
///
/// If treatments have factor levels, each level occurs in a block roughly in proportion to its
/// number of treatments, as far as the first condition allows. This takes precedence over the
/// second condition. `kinds` holds the factor levels of each treatment (its actor, its emotion),
/// numbered from 0 over all factors; empty: none.
///
/// Block i does not depend on `blocks`: further blocks do not change earlier ones. Treatments
/// within a block are in increasing order.
std::vector<std::vector<std::size_t>> incomplete_blocks(
    std::size_t treatments, std::size_t size, std::size_t blocks, std::uint64_t seed,
    const std::vector<std::vector<std::size_t>>& kinds = {});

}  // namespace mien::pipeline
