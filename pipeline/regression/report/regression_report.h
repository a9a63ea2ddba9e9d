#pragma once

#include <string>

#include "pipeline/regression/comparer.h"
#include "pipeline/regression/regression.h"
#include "pipeline/regression/report/report_videos.h"

namespace mien::pipeline {

/// Returns the report as one HTML page that works without a network: causes first, then the stimuli
/// that differ, appeared, are gone or are alike; unchanged stimuli are omitted. A stimulus that
/// differs or is alike can be expanded to show both motions in 3-D, their distance over time and by
/// body part, the key frames that differ with their ꟻLIP map, and videos if the baseline stores
/// them. Former and current pictures are shown under a slider, alternating or as a difference.
/// report_pictures.h and report_videos.h limit how many pictures and videos the page embeds. Reads
/// `study.pictures`. Throws the errors of reading the files.
///
/// `script` is the JavaScript that displays these (bundled by page/build.mjs as regress). If it is
/// empty, the page does not contain these displays, and says so.
std::string regression_report(const Regression& regression, const ComparedStudy& study,
                              const std::string& script, ReportVideos videos = {});

}  // namespace mien::pipeline
