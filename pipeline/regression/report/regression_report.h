#pragma once

#include <string>

#include "pipeline/regression/comparer.h"
#include "pipeline/regression/regression.h"
#include "pipeline/regression/report/report_videos.h"

namespace mien::pipeline {

/// One page that holds all that it shows, for a browser without a network: causes first, then the
/// stimuli that differ, then those that are alike. Of each that is opened: key frames, and videos
/// where the baseline keeps them, under a slider, by turns and as difference; ꟻLIP's map; both
/// motions in 3-D; their distance over time and by part of the body. How many pictures and videos
/// are in the page itself: report_pictures.h, report_videos.h. Reads `study.pictures`. Throws what
/// reading does.
///
/// `script` is what shows them (page/build.mjs bundles it as regress); where it is empty, the page
/// says so, and has its words alone.
std::string regression_report(const Regression& regression, const ComparedStudy& study,
                              const std::string& script, ReportVideos videos = {});

}  // namespace mien::pipeline
