#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "scenes/figures/face.h"

namespace mien::pipeline {

/// `face:`: "neutral", "hidden", weights by name, or a file of weights: {file, take, start, fps}.
struct FaceForm {
  static void read(const DocumentValue& given, scenes::Face& face);
  static nlohmann::ordered_json write(const scenes::Face& face, const WritingOptions& how);
  static void walk(auto& names) {
    for (const char* key : {"file", "take", "start", "fps"}) names.add(key);
  }
};

/// The same of a person, who has the face of the stimulus if none is given.
struct PersonFaceForm {
  static void read(const DocumentValue& given, std::optional<scenes::Face>& face);
  static nlohmann::ordered_json write(const std::optional<scenes::Face>& face,
                                      const WritingOptions& how);
  static void walk(auto& names) { FaceForm::walk(names); }
};

}  // namespace mien::pipeline
