#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// An item of a grid trial: the rating, on a scale, of the stimulus in a place of the grid.
struct GridItem {
  std::string scale;      ///< id
  std::size_t place = 1;  ///< counted from 1
};

/// The name of the item in plans and records: "natural/2". In tables of answers, the item is the
/// scale alone, and the stimulus the one in that place.
inline std::string to_item(const GridItem& item) {
  return item.scale + "/" + std::to_string(item.place);
}

/// The item of that name; nothing if it is none.
inline std::optional<GridItem> grid_item(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  if (slash == std::string_view::npos || slash == 0) return std::nullopt;
  const std::string_view digits = name.substr(slash + 1);
  GridItem item{.scale = std::string(name.substr(0, slash))};
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), item.place);
  const bool is_number = error == std::errc() && end == digits.data() + digits.size();
  if (!is_number || item.place == 0 || digits.front() == '0') return std::nullopt;
  return item;
}

}  // namespace mien::pipeline
