#include "pipeline/study/questionnaire/latin_square.h"

#include <algorithm>

namespace mien::pipeline {

std::size_t williams_rows(std::size_t count) { return count % 2 == 0 ? count : 2 * count; }

std::vector<std::size_t> williams_row(std::size_t count, std::size_t row) {
  std::vector<std::size_t> order(count);
  if (count == 0) return order;
  row %= williams_rows(count);
  // 0, 1, n − 1, 2, n − 2 …: neighbours differ by every number once.
  for (std::size_t place = 0; place < count; ++place) {
    const std::size_t first = place % 2 == 1 ? (place + 1) / 2 : (count - place / 2) % count;
    order[place] = (first + row) % count;
  }
  if (row >= count) std::ranges::reverse(order);
  return order;
}

}  // namespace mien::pipeline
