#include "pipeline/manifest/look/point_form.h"

#include <algorithm>

#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

void assign(const nlohmann::json* value, render::Color& target) {
  if (value == nullptr) return;
  if (value->is_string()) {
    const auto& hex = value->get_ref<const std::string&>();
    if (scenes::is_hex_colour(hex)) target = scenes::colour_from_hex(hex);
    return;
  }
  const auto is_number = [](const nlohmann::json& channel) { return channel.is_number(); };
  if (!value->is_array() || value->size() != 3 || !std::ranges::all_of(*value, is_number)) return;
  for (int c = 0; c < 3; ++c) target[c] = (*value)[static_cast<std::size_t>(c)].get<float>();
}

}  // namespace mien::pipeline
