#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/study/figures/page_figures.h"

namespace mien::pipeline {

// What pages read of a figure (pipeline/study/page/src/figure).

/// A message to a page: u32 length of the JSON, little-endian; the JSON, padded with spaces so that
/// 4 + length is a multiple of 8; the bytes.
std::string framed(const nlohmann::ordered_json& head, const std::string& bytes);

/// "key", "joints", "has_hands", "morphs" and "face_frames", the number of frames of the face (0 if
/// it does not move).
nlohmann::ordered_json figure_json(const PageFigure& figure);

}  // namespace mien::pipeline
