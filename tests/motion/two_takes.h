#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf/gltf.h"
#include "motion/gltf_text.h"
#include "motion/skeleton/recording.h"

namespace mien::test {

/// A motion as glTF text with a second one, "Stand", in which only the root moves; the first is
/// called "Walk".
inline std::string two_takes(const motion::Recording& walk) {
  using nlohmann::json;
  const std::string glb = motion::to_glb(walk);
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof length);
  json document = json::parse(glb.substr(20, length));
  const std::string_view binary = std::string_view(glb).substr(20 + length + 8);
  document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(binary);
  json& takes = document["animations"];
  takes[0]["name"] = "Walk";
  takes.push_back(takes[0]);
  takes[1]["name"] = "Stand";
  takes[1]["channels"] = json::array({takes[1]["channels"][0]});
  return document.dump();
}

}  // namespace mien::test
