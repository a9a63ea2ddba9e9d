#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/questionnaire/rating_spread.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/study/thresholds/simulated_observer.h"

namespace mien::pipeline {

/// The assumed true ratings: (stimulus, scale) → population mean, in the scale's own range. A
/// missing entry stands for the middle of the scale. In detection, (stimulus, name of the kind of
/// trial) → mean of the observations, in their standard deviations, so that differences are values
/// of d′; a missing entry stands for 0.
using StatedTruth = std::map<std::pair<std::string, std::string>, double>;

/// The true rating from a time of the video on, seconds.
struct TruthStep {
  double from_s = 0.0;
  double value = 0.0;
};

/// In continuous trials, true ratings that change while a video plays: (stimulus, scale) → the
/// later ratings, by time; the first one is in StatedTruth.
using TruthCourses = std::map<std::pair<std::string, std::string>, std::vector<TruthStep>>;

struct AssumedTruth {
  StatedTruth ratings;
  TruthCourses courses;  ///< of continuous trials only
};

/// Reads a CSV with the columns stimulus, scale and value; in detection, the scale is the name of
/// the kind of trial. In continuous trials, a column from_s may state from which second of the
/// video on a value holds; the earliest one of a stimulus and scale also holds before its time.
/// Throws Faults for stimuli and scales that are not in the questionnaire, for values that are not
/// numbers or are outside the scale, and for times without continuous trials or given twice.
AssumedTruth read_truth(const Manifest& manifest, const std::filesystem::path& file);

/// Throws Error, with an example of a table for read_truth, if measured_truth lacks a model of a
/// scale.
void refuse_scales_without_model(const Manifest& manifest);

/// True ratings by the model of simulated raters (simulated_raters.h) from features of the motions,
/// which are synthesized. In yes–no and two-interval trials it is 1 for stimuli with the signal and
/// 0 for others, in same–different trials the sum of the impressions of the model. In continuous
/// trials, walks whose mood changes have a rating for each of their moods (mood_stretches). Throws
/// Error if a motion cannot be synthesized or the model lacks a scale.
AssumedTruth measured_truth(const Manifest& manifest);

/// The usual standard deviations on a scale: 0.3 of participants and 0.7 of the residual from -2 to
/// 2, and the same shares of other ranges. `range`: from the low to the high end of the scale.
RatingSpread usual_spread(double range);

/// Parameters of the responses of simulated participants. Standard deviations are in scale units.
struct SimulatedParticipants {
  /// Its `stimulus` is not used: the truth contains the differences between stimuli. Unset: the
  /// usual share of the range of each scale (usual_spread).
  std::optional<RatingSpread> spread = {};
  double attention_pass_rate = 0.98;  ///< probability of passing an attention check, 0 to 1
  double recognition_rate = 0.6;      ///< probability of choosing the intended emotion, 0 to 1
  /// Probability of recognising a hidden reference and rating it 100, 0 to 1.
  double reference_recognition_rate = 0.95;
  double answer_seconds = 2.5;  ///< median response time of an item, seconds
  /// Of continuous trials: seconds between what is seen and its rating, and the durations of films.
  double reaction_lag_s = 2.0;
  VideoSeconds film_seconds = {};
  SimulatedObservers observers = {};  ///< of adaptive trials
};

/// Simulated answers to all trials of all plans. A rating is the truth plus a response bias of the
/// participant on that scale plus a residual, clamped to the scale and rounded to the points of the
/// questionnaire. In grid trials, hidden references that are recognised are rated 100. In a pair,
/// the stimulus with the higher rating before clamping and rounding is chosen. In detection, an
/// observation is the truth plus the bias plus a residual with a standard deviation of 1; the
/// answer is "yes" above 0.5, the interval with the greater observation, or "different" if two
/// observations differ by more than 1.5. In continuous trials, an impression begins at the start of
/// the scale when the film begins and approaches the opinion of the film, which is a rating as
/// above (of the rest, 63 % in 1.5 s), and where the truth changes, it approaches the changed
/// opinion in the same way; the marker follows it after the reaction lag, with deviations that are
/// correlated over time (first order, 1 s; standard deviation half of that of the residual, where
/// the opinion is reached). In adaptive trials, an answer is positive with the probability that the
/// participant's psychometric function has at the level shown (SimulatedObservers) or, without the
/// signal, with its guess rate; levels follow from the answers as on the page. Deterministic in the
/// seed of each plan. Each row is marked as simulated.
std::vector<AnswerRow> simulated_sessions(const Manifest& manifest,
                                          const std::vector<SessionPlan>& plans,
                                          const StatedTruth& truth,
                                          const SimulatedParticipants& people = {},
                                          const TruthCourses& courses = {});

/// Hash of everything that participants see except the media: plans, texts, scales and settings.
std::string design_hash(const Manifest& manifest, const std::vector<SessionPlan>& plans);

}  // namespace mien::pipeline
