#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// An item of a best–worst trial: which of the stimuli is best with respect to a scale, that is,
/// closest to its high end, or which is worst.
struct BestWorstItem {
  std::string scale;  ///< id
  bool is_best = true;
};

/// The name of the item in plans and answers: "sad-happy/best".
inline std::string to_item(const BestWorstItem& item) {
  return item.scale + (item.is_best ? "/best" : "/worst");
}

/// The item of that name; nothing if it is none.
inline std::optional<BestWorstItem> best_worst_item(std::string_view name) {
  for (const bool is_best : {true, false}) {
    const std::string_view ending = is_best ? "/best" : "/worst";
    if (name.ends_with(ending) && name.size() > ending.size())
      return BestWorstItem{std::string(name.substr(0, name.size() - ending.size())), is_best};
  }
  return std::nullopt;
}

}  // namespace mien::pipeline
