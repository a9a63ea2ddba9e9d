#include "pipeline/study/figures/figure_message.h"

#include <cstdint>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

using nlohmann::ordered_json;

std::string framed(const ordered_json& head, const std::string& bytes) {
  std::string text = head.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  while ((text.size() + 4) % 8 != 0) text += ' ';
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string whole;
  for (int i = 0; i < 4; ++i) whole += static_cast<char>((length >> (8 * i)) & 0xff);
  return whole + text + bytes;
}

ordered_json figure_json(const PageFigure& figure) {
  const std::size_t weights = figure.face.size() / sizeof(float);
  return {
      {"key", figure.key},
      {"joints", figure.joints},
      {"has_hands", figure.has_hands},
      {"morphs", figure.morphs},
      {"face_frames", figure.morphs == 0 ? 0 : weights / static_cast<std::size_t>(figure.morphs)}};
}

}  // namespace mien::pipeline
