#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/regression/baseline.h"
#include "pipeline/regression/rendition.h"

namespace mien::pipeline {

struct ApprovalOptions {
  int key_frames = 4;                 ///< kept of each stimulus, at most
  std::filesystem::path videos_from;  ///< study whose videos are kept too; empty: none are
  int threads = 1;
};

/// Stores stimuli as they are now, all or those of `approval.only`, as the reference for later
/// comparisons. `folder` holds a baseline of the study, or nothing. What is not approved stays as
/// it was; of stimuli that the manifest has no more, nothing is kept once that is approved. A
/// stimulus is replaced as a whole, all of them when all are made, so that what is interrupted
/// before leaves the baseline as it was. `inputs` are the hashes of what the manifest names, as it
/// was read (put_inputs). Throws Error and Interrupted.
Baseline approve(Rendition& now, const std::filesystem::path& folder, const Approval& approval,
                 const std::map<std::string, std::vector<VideoFacts>>& videos,
                 const std::map<std::string, Hash>& inputs, const ApprovalOptions& options,
                 const std::stop_token& stop, const std::function<void(double)>& done);

/// The videos of a stimulus in a study's folder, as they were checked when they were made. Empty
/// when there is no record of them.
std::vector<VideoFacts> videos_of(const std::string& id, const std::filesystem::path& folder);

}  // namespace mien::pipeline
