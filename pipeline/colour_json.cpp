#include "pipeline/colour_json.h"

#include <algorithm>

#include "render/tone.h"

namespace mien::pipeline {

render::Color colour_from_hex(const std::string& hex) {
  const auto channel = [&](std::size_t at) { return std::stoi(hex.substr(at, 2), nullptr, 16); };
  return render::linear_from_srgb8(channel(1), channel(3), channel(5));
}

void assign(const nlohmann::json* value, render::Color& target) {
  if (value == nullptr) return;
  if (value->is_string()) {
    const auto& hex = value->get_ref<const std::string&>();
    const bool is_hex = hex.size() == 7 && hex[0] == '#' &&
                        hex.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (is_hex) target = colour_from_hex(hex);
    return;
  }
  const auto is_number = [](const nlohmann::json& channel) { return channel.is_number(); };
  if (!value->is_array() || value->size() != 3 || !std::ranges::all_of(*value, is_number)) return;
  for (int c = 0; c < 3; ++c) target[c] = (*value)[static_cast<std::size_t>(c)].get<float>();
}

}  // namespace mien::pipeline
