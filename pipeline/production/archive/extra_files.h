#pragma once

#include <string>
#include <vector>

#include "pipeline/production/archive/study_contents.h"

namespace mien::pipeline {

/// Files in a study's folder that neither its provenance nor the store's receipts know, by path:
/// nobody's, as far as mien can tell. What lies in a known sequence of frames is not looked at.
std::vector<std::string> extra_files(const StudyContents& contents);

}  // namespace mien::pipeline
