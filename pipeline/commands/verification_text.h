#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/commands/line/console.h"
#include "pipeline/production/archive/verify.h"

namespace mien::pipeline {

/// Verifies a study and shows progress.
Verification verified(const StudyContents& contents, int threads, const Console& console);

/// Prints one line per finding (for artifacts that were not kept, one line per folder), and a
/// summary.
void print_result(const Verification& verification, const StudyContents& contents,
                  const Console& console);

nlohmann::ordered_json as_json(const Verification& verification, const StudyContents& contents);

/// "61.3 MB"
std::string size_text(std::uint64_t bytes);

}  // namespace mien::pipeline
