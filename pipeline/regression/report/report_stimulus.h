#pragma once

#include <nlohmann/json.hpp>

#include "pipeline/regression/comparer.h"
#include "pipeline/regression/report/report_pictures.h"

namespace mien::pipeline {

/// Key frames of a stimulus for the page's script: what was measured, and the pictures. An empty
/// list where none is shown. Throws what reading does.
nlohmann::ordered_json frames_json(const StimulusComparison& one, const ComparedPictures& pictures,
                                   const ReportPictures& chosen);

/// Both motions of a stimulus and their distances for the page's script. World places of joints,
/// frame by frame, are 16-bit numbers, little end first, in base64, in steps of so many
/// millimetres; distances are in millimetres. `one.motion` is known. Throws what reading does.
nlohmann::ordered_json motion_json(const StimulusComparison& one, const ComparedStudy& study);

}  // namespace mien::pipeline
