#pragma once

#include <filesystem>

#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

struct ChainDesignCommand {
  int participants = 0;               ///< 0: the number planned in the manifest
  std::filesystem::path plans;        ///< CSV to write; empty: standard output
  std::filesystem::path frozen = {};  ///< archive for a preregistration; empty: none
};

/// Plans the sessions of an adaptive experiment, writes the plans, and prints the dimensions with
/// their ranges, the number of answers that the chains need, and the duration; writes the archive
/// (frozen_chains). Returns the exit code.
int design_chains(const Manifest& manifest, const ChainDesignCommand& design,
                  const Console& console);

}  // namespace mien::pipeline
