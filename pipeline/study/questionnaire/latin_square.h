#pragma once

#include <cstddef>
#include <vector>

namespace mien::pipeline {

/// A row of Williams' Latin square of 0 … count − 1 (Williams 1949), after which all is said that
/// can be said in so few rows: in `count` rows everything comes once in every place. For an even
/// count, everything follows everything else once in these `count` rows; for an odd one twice in
/// 2·count rows, of which the second half are the first in reverse. `row` may be any number: they
/// go round.
std::vector<std::size_t> williams_row(std::size_t count, std::size_t row);

/// Rows after which everything has followed everything else equally often: count, or 2·count.
std::size_t williams_rows(std::size_t count);

}  // namespace mien::pipeline
