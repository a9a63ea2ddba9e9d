#pragma once

#include <array>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

// The columns of the tables that tables.h writes.

inline constexpr Column ratings_column = {"ratings", "",
                                          "ratings on which the motion is based: given (by "
                                          "people), simulated or none (features, weights, files)"};

inline constexpr std::array distances_columns = std::to_array<Column>({
    {"sheet", "", "comparison sheet"},
    {"target", "", "reference stimulus or example"},
    {"created", "", "stimulus or example compared with it"},
    ratings_column,
    {"alignment", "", "pelvis: position and heading of the body removed; world: kept"},
    {"d_m", "m",
     "D: mean distance over 20 joints and 11 corresponding moments; planted feet of motion files "
     "are locked to the floor first, as in blends"},
    {"d_sum_m", "m", "sum of the same distances, as in the published formula"},
    {"mpjpe_m", "m", "mean joint distance over all frames (MPJPE)"},
    {"threshold_m", "m",
     "threshold of D at which a trial of the adjective paper's matching task ends"},
    {"match", "0/1",
     "1: D is below the threshold of the adjective paper's matching task, which does not consider "
     "single joints, durations or perceptibility; empty for gallery sheets"},
});

inline constexpr std::array joint_distances_columns = std::to_array<Column>({
    {"sheet", "", "comparison sheet"},
    {"target", "", "reference stimulus or example"},
    {"created", "", "stimulus or example compared with it"},
    ratings_column,
    {"joint", "", "joint"},
    {"time", "0–1", "time, as a fraction of the duration"},
    {"distance_m", "m", "distance of the joint from its position in the target"},
});

inline constexpr std::array weights_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    ratings_column,
    {"example", "", "example label"},
    {"weight", "",
     "blend weight; the weights of a stimulus sum to 1 (those of a statistical model may be "
     "negative)"},
});

inline constexpr std::array clips_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    {"role", "", "target, created or reference"},
    ratings_column,
    {"source", "", "source of the motion: adjectives, features, weights or clip"},
    {"frames", "", "number of frames shown, over all cycles"},
    {"duration_s", "s", "duration shown, over all cycles"},
    {"fps", "1/s", "frames per second"},
    {"cycle_s", "s", "duration of one cycle; empty for motions that do not loop"},
    {"stride_m", "m",
     "stride length: distance travelled in one cycle; empty for motions that do not loop"},
    {"speed_m_s", "m/s", "mean speed over the floor"},
    {"planted_drift_m", "m", "largest displacement of a planted foot"},
    {"method", "",
     "interpolation method by which blend weights were found, or direct for given weights; empty "
     "for a file"},
    {"expected_error_m", "m",
     "expected error of joint positions, where the method estimates it (kriging)"},
    {"modified", "", "modifications applied to the motion; empty for none"},
    {"modified_share", "0–1",
     "proportion of the requested modification strength that was applied; below 1 where on_fault "
     "reduced it"},
});

inline constexpr std::array parameters_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    ratings_column,
    {"parameter", "", "scale, group of scales or motion feature"},
    {"asked", "0–1", "requested value; empty if none"},
    {"held", "0–1", "value at which the parameter is held; empty if it is not held"},
    {"reached", "0–1",
     "value reached: 0 low end of the scale, 1 high end; for features 0 smallest and 1 largest of "
     "the examples; for a modified motion, before modification"},
    {"least", "0–1",
     "lower end of the feasible range: the least that blends of the examples reach with the other "
     "requested parameters met"},
    {"most", "0–1", "upper end of the feasible range"},
    {"name", "", "English name: \"sad – happy\", low end first"},
    {"name_ja", "", "Japanese name"},
});

inline constexpr std::array examples_columns = std::to_array<Column>({
    {"example", "", "example label, as in weights and ratings"},
    {"file", "", "motion file; empty for a built-in example"},
    {"take_fps", "1/s", "frames per second of the file"},
    {"take_frames", "", "frames in the file"},
    {"first_frame", "", "first frame of the part used, counted from 0"},
    {"last_frame", "",
     "last frame of that part; of a cycle, the one that coincides with the first"},
    {"first_s", "s", "time of the first frame in the file"},
    {"last_s", "s", "time of the last frame in the file"},
    {"loops", "0/1", "1: one gait cycle, closed to a loop"},
    {"mirrored", "0/1", "1: the file holds one step only; the other is its mirror image"},
    {"duration_s", "s", "duration of the example"},
    {"keytimes_s", "s",
     "keytimes: corresponding moments from the example's start, separated by spaces; of a gait "
     "cycle: left heel strike, right toe off, left mid-stance, right heel strike, left toe off, "
     "right mid-stance, left heel strike"},
});

inline constexpr std::array expectations_columns = std::to_array<Column>({
    {"parameter", "", "scale or group for which an order is expected"},
    {"ratings", "", "source of the ratings: given (by people) or simulated"},
    {"place", "", "rank in the expected order, 1 nearest to the low end"},
    {"example", "", "label of the example expected at that rank"},
    {"value", "0–1", "mean rating: 0 low end of the scale, 1 high end"},
    {"above_previous", "0/1", "1: rated above the example expected below it; empty for the first"},
    {"people", "", "participants who rated this example and the one before"},
    {"difference", "0–1", "mean over them of this example's value minus that of the one before"},
    {"difference_low", "0–1", "lower end of its 95 % interval (paired t)"},
    {"difference_high", "0–1", "upper end of that interval"},
    {"holds", "0/1", "1: the whole order is as expected"},
    {"is_certain", "0/1", "1: every step is significant: its interval lies above 0"},
});

inline constexpr std::array findings_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    {"check", "", "lint rule"},
    {"severity", "", "error or warning"},
    {"joint", "", "joint; empty if none is concerned"},
    {"first_frame", "", "first frame of the finding, within one cycle or the whole clip"},
    {"last_frame", "", "last frame of the finding"},
    {"first_s", "s", "time of the first frame"},
    {"last_s", "s", "time of the last frame"},
    {"measured", "see unit", "measured value"},
    {"threshold", "see unit", "limit of the rule"},
    {"unit", "", "unit of value and limit"},
    {"sentence", "", "description of the finding"},
});

inline constexpr std::array feature_changes_columns = std::to_array<Column>({
    {"sheet", "", "comparison sheet"},
    {"reference", "", "reference stimulus or example"},
    {"target", "", "target stimulus or example"},
    {"created", "", "stimulus or example that should change in the same direction"},
    ratings_column,
    {"feature", "", "id of the motion feature"},
    {"name", "", "English name"},
    {"name_ja", "", "Japanese name"},
    {"unit", "", "unit of the following three values"},
    {"reference_value", "see unit", "value of the reference"},
    {"target_change", "see unit", "target minus reference"},
    {"created_change", "see unit", "created motion minus reference"},
    {"moved", "0/1", "1: the target differs measurably from the reference"},
    {"agrees", "0/1",
     "1: the created motion differs measurably in the same direction; empty if the target does not "
     "differ"},
});

inline constexpr std::array foils_columns = std::to_array<Column>({
    {"foil", "", "id of the foil"},
    {"of", "", "id of the stimulus of which it is a foil"},
    {"differ", "", "aspect in which the two are intended to differ"},
    {"aspect", "", "aspect of this row: posture, path-length, speed or acceleration"},
    {"measure", "", "measure compared between the two finished motions, with its unit"},
    {"of_value", "see measure", "value of the stimulus; empty if only the difference is known"},
    {"foil_value", "see measure", "value of the foil"},
    {"difference", "° or share",
     "for posture, the largest difference of a joint rotation in degrees; otherwise the ratio of "
     "the foil's value to the stimulus's, minus 1"},
    {"is_held", "0/1",
     "1: the difference is below 2°, or 0.05; empty for the aspect intended to differ"},
});

inline constexpr TableForm distances_form = {"metrics/distances.csv", "compared pair",
                                             distances_columns};
inline constexpr TableForm joint_distances_form = {
    "metrics/joint_distances.csv", "compared pair, joint and time", joint_distances_columns};
inline constexpr TableForm weights_form = {"metrics/weights.csv", "stimulus and example",
                                           weights_columns};
inline constexpr TableForm clips_form = {"metrics/clips.csv", "stimulus", clips_columns};
inline constexpr TableForm parameters_form = {
    "metrics/parameters.csv", "stimulus and parameter: first the requested ones, then all others",
    parameters_columns};
inline constexpr TableForm examples_form = {"metrics/examples.csv", "example", examples_columns};
inline constexpr TableForm expectations_form = {
    "metrics/expectations.csv", "example of an expected order", expectations_columns};
inline constexpr TableForm foils_form = {"metrics/foils.csv", "foil and aspect", foils_columns};
inline constexpr TableForm findings_form = {"metrics/findings.csv", "lint finding",
                                            findings_columns};
inline constexpr TableForm feature_changes_form = {"metrics/feature_changes.csv",
                                                   "comparison with a reference, and feature",
                                                   feature_changes_columns};

}  // namespace mien::pipeline
