#pragma once

#include <nlohmann/json.hpp>

#include "pipeline/study/thresholds/track_procedure.h"

namespace mien::pipeline {

/// The procedure as pages for participants read it (page/src/questionnaire/adaptive/tracks.ts).
nlohmann::ordered_json procedure_json(const TrackProcedure& procedure);

/// Reads what procedure_json writes. Throws nlohmann::json::exception for JSON of another form.
TrackProcedure procedure_of(const nlohmann::ordered_json& text);

}  // namespace mien::pipeline
