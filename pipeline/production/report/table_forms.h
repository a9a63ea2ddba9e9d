#pragma once

#include <array>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

// The columns of the tables that tables.h writes.

inline constexpr Column ratings_column = {
    "ratings", "",
    "whose ratings the motion rests on: given (by people), simulated, or none (features, weights, "
    "files)"};

inline constexpr std::array distances_columns = std::to_array<Column>({
    {"sheet", "", "the sheet that compares them"},
    {"target", "", "stimulus or example that is measured against"},
    {"created", "", "stimulus or example that is measured"},
    ratings_column,
    {"alignment", "", "pelvis: place and heading of the body are taken out; world: they are not"},
    {"d_m", "m",
     "D: mean distance over 20 joints and 11 corresponding moments; feet of motion files are "
     "settled "
     "first, as those of blends are"},
    {"d_sum_m", "m", "the same distances summed, as the formula is printed"},
    {"mpjpe_m", "m", "mean distance of the joints over all frames"},
    {"threshold_m", "m",
     "a trial of the adjective paper's matching task ends when D is below this"},
    {"match", "0/1",
     "1: D is below the threshold of the adjective paper's matching task, which says nothing of "
     "single joints, of durations and of whether people see a difference; empty for what a gallery "
     "sets side by side"},
});

inline constexpr std::array joint_distances_columns = std::to_array<Column>({
    {"sheet", "", "the sheet that compares them"},
    {"target", "", "stimulus or example that is measured against"},
    {"created", "", "stimulus or example that is measured"},
    ratings_column,
    {"joint", "", "joint of the body"},
    {"time", "0–1", "moment, as a share of the duration"},
    {"distance_m", "m", "distance of the joint from where the target has it"},
});

inline constexpr std::array weights_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    ratings_column,
    {"example", "", "label of the example"},
    {"weight", "",
     "its share of the blend; the shares of a stimulus sum to 1 (a statistical model's may be "
     "negative)"},
});

inline constexpr std::array clips_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    {"role", "", "target, created or reference"},
    ratings_column,
    {"source", "", "what the motion is made from: adjectives, features, weights or clip"},
    {"frames", "", "frames of what is shown, all cycles"},
    {"duration_s", "s", "duration of what is shown"},
    {"fps", "1/s", "frames a second"},
    {"cycle_s", "s", "duration of one cycle; empty where nothing loops"},
    {"stride_m", "m", "way over the floor in one cycle; empty where nothing loops"},
    {"speed_m_s", "m/s", "way over the floor by the time that it takes"},
    {"planted_drift_m", "m", "farthest that a planted foot slides"},
    {"method", "",
     "how the shares of the examples were found: a method of interpolation, or direct for given "
     "weights; empty for a file"},
    {"expected_error_m", "m", "how far joints may be off, where the method tells (kriging)"},
    {"modified", "", "what was done to the motion; empty for nothing"},
    {"modified_share", "0–1",
     "share of the strengths asked for that was kept: below 1 where on_fault reduced them"},
});

inline constexpr std::array parameters_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    ratings_column,
    {"parameter", "", "scale, group of scales or motion feature"},
    {"asked", "0–1", "what the stimulus asks for; empty where it asks for nothing"},
    {"held", "0–1", "where the stimulus holds it; empty where it does not"},
    {"reached", "0–1",
     "what the motion has: 0 the low end of the scale, 1 the high end; of features 0 the smallest "
     "of the examples, 1 the largest; of a modified motion as it was before"},
    {"least", "0–1",
     "least that blends of the examples can have of what is asked for, the other wishes met"},
    {"most", "0–1", "most that they can have of it"},
    {"name", "", "English name: \"sad – happy\", low end first"},
    {"name_ja", "", "Japanese name"},
});

inline constexpr std::array examples_columns = std::to_array<Column>({
    {"example", "", "label, as weights and ratings name it"},
    {"file", "", "name of the motion file; empty for a built-in example"},
    {"take_fps", "1/s", "frames a second of the file"},
    {"take_frames", "", "frames in the file"},
    {"first_frame", "", "first frame of the part that was cut out, counted from 0"},
    {"last_frame", "", "last frame of that part; of a cycle, the one that meets the first again"},
    {"first_s", "s", "time of the first frame in the file"},
    {"last_s", "s", "time of the last frame in the file"},
    {"loops", "0/1", "1: one gait cycle, closed to a loop"},
    {"mirrored", "0/1", "1: the file held one step only, the other is its mirror image"},
    {"duration_s", "s", "duration of the example"},
    {"keytimes_s", "s",
     "corresponding moments, parted by blanks, from the example's start; of a gait cycle: left "
     "heel strike, right toe off, left mid-stance, right heel strike, left toe off, right "
     "mid-stance, left heel strike"},
});

inline constexpr std::array expectations_columns = std::to_array<Column>({
    {"parameter", "", "scale or group that an order was expected on"},
    {"ratings", "", "whose ratings: given (by people) or simulated"},
    {"place", "", "place in the expected order, 1 nearest to the low end"},
    {"example", "", "label of the example expected there"},
    {"value", "0–1", "where people put it: 0 the low end of the scale, 1 the high end"},
    {"above_previous", "0/1",
     "1: it lies above the example expected below it; empty for the first"},
    {"people", "", "people who rated this example and the one before"},
    {"difference", "0–1", "mean over them of this example's value minus the one's before"},
    {"difference_low", "0–1", "low end of its 95 % interval (paired t)"},
    {"difference_high", "0–1", "high end of it"},
    {"holds", "0/1", "1: the whole order is as expected"},
    {"is_certain", "0/1", "1: every step of it is more than noise: its interval lies above 0"},
});

inline constexpr std::array findings_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    {"check", "", "rule of the lint"},
    {"severity", "", "error or warning"},
    {"joint", "", "joint of the body; empty where none is meant"},
    {"first_frame", "", "first frame of the finding, in one cycle or the whole clip"},
    {"last_frame", "", "last frame of the finding"},
    {"first_s", "s", "time of the first frame"},
    {"last_s", "s", "time of the last frame"},
    {"measured", "see unit", "what was measured"},
    {"threshold", "see unit", "what the rule allows"},
    {"unit", "", "unit of the two"},
    {"sentence", "", "the finding in words"},
});

inline constexpr std::array feature_changes_columns = std::to_array<Column>({
    {"sheet", "", "the sheet that compares them"},
    {"reference", "", "stimulus or example that both are held against"},
    {"target", "", "stimulus or example that shows the way"},
    {"created", "", "stimulus or example that should go the same way"},
    ratings_column,
    {"feature", "", "id of the motion feature"},
    {"name", "", "English name"},
    {"name_ja", "", "Japanese name"},
    {"unit", "", "unit of the three numbers"},
    {"reference_value", "see unit", "the feature of the reference"},
    {"target_change", "see unit", "target minus reference: positive where the target has more"},
    {"created_change", "see unit",
     "created minus reference: positive where the created motion has more"},
    {"moved", "0/1", "1: the target differs measurably from the reference"},
    {"agrees", "0/1",
     "1: the created motion differs measurably the same way; empty where the target has not moved"},
});

inline constexpr std::array foils_columns = std::to_array<Column>({
    {"foil", "", "id of the foil"},
    {"of", "", "id of the stimulus that it is a foil of"},
    {"differ", "", "aspect in which the two are meant to differ"},
    {"aspect", "", "aspect of this row: posture, path-length, speed or acceleration"},
    {"measure", "", "what was measured of both finished motions, with its unit"},
    {"of_value", "see measure", "of the stimulus; empty where only the difference is known"},
    {"foil_value", "see measure", "of the foil"},
    {"difference", "° or share",
     "of the posture the largest turn of a joint, degrees; otherwise the foil's value by the "
     "other's, minus 1"},
    {"is_held", "0/1",
     "1: the difference is below 2°, or 0.05; empty for the aspect that is meant to differ"},
});

inline constexpr TableForm distances_form = {"metrics/distances.csv", "a compared pair",
                                             distances_columns};
inline constexpr TableForm joint_distances_form = {
    "metrics/joint_distances.csv", "a compared pair, joint and time", joint_distances_columns};
inline constexpr TableForm weights_form = {"metrics/weights.csv", "a stimulus and example",
                                           weights_columns};
inline constexpr TableForm clips_form = {"metrics/clips.csv", "a stimulus", clips_columns};
inline constexpr TableForm parameters_form = {
    "metrics/parameters.csv", "a stimulus and parameter: first those asked for, then all others",
    parameters_columns};
inline constexpr TableForm examples_form = {"metrics/examples.csv", "an example", examples_columns};
inline constexpr TableForm expectations_form = {
    "metrics/expectations.csv", "an example of an expected order", expectations_columns};
inline constexpr TableForm foils_form = {"metrics/foils.csv", "a foil and aspect", foils_columns};
inline constexpr TableForm findings_form = {"metrics/findings.csv", "a finding of the lint",
                                            findings_columns};
inline constexpr TableForm feature_changes_form = {"metrics/feature_changes.csv",
                                                   "a comparison with a reference and a feature",
                                                   feature_changes_columns};

}  // namespace mien::pipeline
