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
  std::string id;             ///< id of the copied stimulus; empty if no stimulus could be used
  std::string motion_defect;  ///< "left forearm turned by 1°"
  bool motion_caught = true;
  std::string picture_defect;  ///< "a block of 8 x 8 pixels 50 % brighter"
  bool picture_caught = true;

  /// Whether all planted defects were detected; true also if none was planted.
  bool holds() const { return motion_caught && picture_caught; }
};

/// Plants the defects in a stimulus that is in the baseline and in the current manifest: rotates a
/// joint of its current motion by 1° relative to the parent, and brightens a block of an approved
/// picture by half, in the picture's block statistics. The choice depends on the baseline's
/// approvals. Throws Error if the baseline is damaged.
Gate plant_defects(const ComparedStudy& study);

/// The result of making everything several times; there must be no differences.
struct Repetitions {
  int times = 1;  ///< number of times that everything was made
  /// Number of motions and key frames that differed from the first ones, summed over the
  /// repetitions.
  int differing = 0;
  double largest = 0.0;  ///< largest difference of a channel, as a share of full scale
};

/// Makes the motions and key frames of the current study `times` times, for the stimuli that are
/// selected and in the baseline, and compares the results with the first ones bit by bit. The
/// number of threads starts at one and increases by one each time; after the number of processors,
/// it starts again at one. For `times` 1, does nothing. Throws Error and Interrupted.
Repetitions repeated(const ComparedStudy& study, int times);

/// Stimuli with the same cause of change, which can be approved together.
struct CauseGroup {
  Cause cause = Cause::unknown;
  std::string root;
  std::vector<std::string> ids;  ///< ids of the stimuli changed by this cause
  bool differs = false;          ///< whether the verdict of any of them is `differs`
};

/// Returns the groups: first those with a stimulus that differs, then the others, both in
/// descending order of the number of stimuli.
std::vector<CauseGroup> groups_of(const std::vector<StimulusComparison>& stimuli);

/// A study compared with its baseline.
struct Regression {
  std::string study;
  /// In the manifest's order, then removed stimuli, then overlays, of which only videos and
  /// settings are compared.
  std::vector<StimulusComparison> stimuli;
  std::vector<CauseGroup> groups;  ///< in the order of groups_of
  Gate gate;
  Repetitions repetitions;
  /// Tolerances that were widened since the approval ("position_mm 1 → 50"), with the ids of the
  /// stimuli concerned.
  std::map<std::string, std::vector<std::string>> wider;
  /// Ids of stimuli and overlays, present or removed, that were not selected; their state is
  /// unknown.
  std::vector<std::string> not_compared;
  /// Ids of stimuli and overlays whose videos are not compared, because none of them was approved.
  std::vector<std::string> without_videos;
  int audited = 0;  ///< number of stimuli selected by `audit_share`

  int count(Verdict verdict) const;
  bool passes() const;  ///< no stimulus differs, appeared, was removed or differed on repetition,
                        ///< and the planted defects were detected
};

struct RegressionOptions {
  /// Share of the stimuli whose key frames are rendered even if none of their inputs has changed;
  /// selected pseudorandomly.
  double audit_share = 0.02;
};

/// Called after each compared stimulus of the manifest with the completed share, 0 … 1.
using StimulusDone = std::function<void(double share, const StimulusComparison&)>;

/// Compares all stimuli and overlays, or those in `study.only`. `videos` are the current videos by
/// id; the videos of stimuli and overlays without an entry were not made and are not compared.
/// Leaves `repetitions` unset (see repeated). Throws Error and Interrupted.
Regression regress(const ComparedStudy& study,
                   const std::map<std::string, std::vector<VideoFacts>>& videos,
                   const RegressionOptions& options, const StimulusDone& done);

}  // namespace mien::pipeline
