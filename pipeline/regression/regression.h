#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "pipeline/regression/comparer.h"

namespace mien::pipeline {

/// Whether the comparison would have seen a small defect: one is planted in copies in each run.
struct Gate {
  std::string id;             ///< of the stimulus that was copied; empty: there was none to copy
  std::string motion_defect;  ///< "left forearm turned by 1°"
  bool motion_caught = true;
  std::string picture_defect;  ///< "a block of 8 x 8 pixels lighter by half"
  bool picture_caught = true;

  /// Both were seen.
  bool holds() const { return motion_caught && picture_caught; }
};

/// Turns a joint of an approved motion by 1° on its parent, and lightens a block of an approved
/// picture by half; which ones, the baseline's approvals decide. Throws Error when the baseline is
/// damaged.
Gate plant_defects(const ComparedStudy& study);

/// What came of making everything several times: must be nothing.
struct Repetitions {
  int times = 1;         ///< that everything was made
  int differing = 0;     ///< motions and key frames that came out differently
  double largest = 0.0;  ///< difference of their channels, as share of full scale
};

/// Makes all motions and key frames of the baseline's stimuli anew, each time with one thread more
/// (as many as there are processors, then one again), and compares them bit by bit. Once: does
/// nothing. Throws Error and Interrupted.
Repetitions repeated(const ComparedStudy& study, int times);

/// Stimuli that differ for one reason, and can be decided on together.
struct CauseGroup {
  Cause cause = Cause::unknown;
  std::string root;
  std::vector<std::string> ids;  ///< of the stimuli that this cause changes
  bool differs = false;          ///< whether one of them differs
};

/// The largest first, those that differ before others.
std::vector<CauseGroup> groups_of(const std::vector<StimulusComparison>& stimuli);

/// A study compared with its baseline.
struct Regression {
  std::string study;
  std::vector<StimulusComparison> stimuli;  ///< in the manifest's order; those that are gone last
  std::vector<CauseGroup> groups;           ///< the largest first, those that differ before others
  Gate gate;
  Repetitions repetitions;
  /// Stimuli by each sentence of wider_limits that applies to them.
  std::map<std::string, std::vector<std::string>> wider;
  /// Ids of stimuli that were not selected, made or gone: nothing is known about them.
  std::vector<std::string> not_compared;
  std::vector<std::string> without_videos;  ///< ids: videos were made, and none are approved
  int audited = 0;  ///< stimuli that were drawn although they cannot have changed

  int count(Verdict verdict) const;
  bool passes() const;  ///< nothing differs, appeared, is gone or came out differently
                        ///< when it was repeated, and the planted defects are seen
};

struct RegressionOptions {
  double audit_share = 0.02;  ///< of the stimuli that need not be drawn: so many are nevertheless
};

/// Called after each stimulus with the share that is done.
using StimulusDone = std::function<void(double share, const StimulusComparison&)>;

/// Compares all stimuli, or those of `study.only`. `videos` are those that were made of them, by
/// their ids. Throws Error and Interrupted.
Regression regress(const ComparedStudy& study,
                   const std::map<std::string, std::vector<VideoFacts>>& videos,
                   const RegressionOptions& options, const StimulusDone& done);

}  // namespace mien::pipeline
