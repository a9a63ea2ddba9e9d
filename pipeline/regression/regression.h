#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "pipeline/regression/comparer.h"

namespace mien::pipeline {

/// A self-test of the comparison: in each run, small defects are planted in copies, and must be
/// detected.
struct Gate {
  std::string id;             ///< id of the copied stimulus; empty if there was none
  std::string motion_defect;  ///< "left forearm turned by 1°"
  bool motion_caught = true;
  std::string picture_defect;  ///< "a block of 8 x 8 pixels 50 % brighter"
  bool picture_caught = true;

  /// Whether both defects were detected.
  bool holds() const { return motion_caught && picture_caught; }
};

/// Plants the defects: rotates a joint of an approved motion by 1° relative to its parent, and
/// brightens a block of an approved picture by half. The choice depends on the baseline's
/// approvals. Throws Error if the baseline is damaged.
Gate plant_defects(const ComparedStudy& study);

/// The result of making everything several times; there must be no differences.
struct Repetitions {
  int times = 1;         ///< number of times that everything was made
  int differing = 0;     ///< number of motions and key frames that differed
  double largest = 0.0;  ///< largest difference of a channel, as a share of full scale
};

/// Makes all motions and key frames of the baseline's stimuli `times` times and compares the
/// results bit by bit. The number of threads starts at one and increases by one each time; after
/// the number of processors, it starts again at one. For `times` 1, does nothing. Throws Error and
/// Interrupted.
Repetitions repeated(const ComparedStudy& study, int times);

/// Stimuli with the same cause of change, which can be approved together.
struct CauseGroup {
  Cause cause = Cause::unknown;
  std::string root;
  std::vector<std::string> ids;  ///< ids of the stimuli changed by this cause
  bool differs = false;          ///< whether the verdict of any of them is `differs`
};

/// Returns the groups: first those with a stimulus that differs, then the others, each from the
/// largest to the smallest.
std::vector<CauseGroup> groups_of(const std::vector<StimulusComparison>& stimuli);

/// A study compared with its baseline.
struct Regression {
  std::string study;
  std::vector<StimulusComparison> stimuli;  ///< in the manifest's order; removed stimuli last
  std::vector<CauseGroup> groups;           ///< in the order of groups_of
  Gate gate;
  Repetitions repetitions;
  /// Ids of the stimuli to which each sentence of wider_limits applies.
  std::map<std::string, std::vector<std::string>> wider;
  /// Ids of stimuli, present or removed, that were not selected; their state is unknown.
  std::vector<std::string> not_compared;
  /// Ids of stimuli with videos of which none is approved.
  std::vector<std::string> without_videos;
  int audited = 0;  ///< number of stimuli rendered although none of their inputs has changed

  int count(Verdict verdict) const;
  bool passes() const;  ///< no stimulus differs, appeared, was removed or differed on repetition,
                        ///< and the planted defects were detected
};

struct RegressionOptions {
  double audit_share = 0.02;  ///< share of the unchanged stimuli that are rendered nevertheless
};

/// Called after each stimulus with the completed share, 0 … 1.
using StimulusDone = std::function<void(double share, const StimulusComparison&)>;

/// Compares all stimuli, or those in `study.only`. `videos` are the current videos by stimulus id.
/// Throws Error and Interrupted.
Regression regress(const ComparedStudy& study,
                   const std::map<std::string, std::vector<VideoFacts>>& videos,
                   const RegressionOptions& options, const StimulusDone& done);

}  // namespace mien::pipeline
