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
  int key_frames = 4;                 ///< maximum number of key frames stored per stimulus
  std::filesystem::path videos_from;  ///< study folder whose videos are stored too; empty: none
  int threads = 1;
};

/// Stores the current state of all stimuli, or of those in `approval.only`, as the reference for
/// later comparisons. `folder` is empty or contains a baseline of the study. Stimuli that are not
/// approved remain unchanged; stimuli that the manifest no longer contains are removed if
/// `approval.only` names them or is empty. Each stimulus is replaced as a whole, and only after all
/// have been made, so that an interruption before that leaves the baseline unchanged. `inputs` are
/// the hashes of the files that the manifest names, as they were read (put_inputs). `done`, if set,
/// is called after each stimulus with the completed share, 0 … 1. Throws Error, also if `folder`
/// contains another study's baseline, and Interrupted.
Baseline approve(Rendition& now, const std::filesystem::path& folder, const Approval& approval,
                 const std::map<std::string, std::vector<VideoFacts>>& videos,
                 const std::map<std::string, Hash>& inputs, const ApprovalOptions& options,
                 const std::stop_token& stop, const std::function<void(double)>& done);

/// Returns the records of a stimulus's videos in a study's folder, as checked when they were made;
/// empty if there are none. Videos whose files are missing are omitted.
std::vector<VideoFacts> videos_of(const std::string& id, const std::filesystem::path& folder);

}  // namespace mien::pipeline
