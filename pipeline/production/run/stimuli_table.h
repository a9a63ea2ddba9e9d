#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

inline constexpr std::array stimuli_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus or overlay, as used in all other tables"},
    {"kind", "", "stimulus or overlay"},
    {"role", "", "target, created or reference; empty for an overlay"},
    {"factor_*", "",
     "level of a design factor; emotion, strength, example and clip are filled in where they "
     "follow from the stimulus; otherwise empty"},
    {"source", "",
     "source of the motion: adjectives, features, weights or clip; motions for an overlay"},
    {"asked", "", "requested values (name=value), file, or motions of an overlay"},
    {"ratings", "",
     "ratings on which the motion is based: given (by people), simulated or none (features, "
     "weights, files)"},
    {"method", "", "method by which blend weights were found; empty for a file"},
    {"modified", "", "modifications applied to the motion; empty for none"},
    {"modified_share", "0–1",
     "proportion of the requested modification strength that was applied; below 1 where on_fault "
     "reduced it"},
    {"scene", "", "the set"},
    {"figure", "", "figure type"},
    {"figure_options", "", "figure options that differ from the defaults, as JSON"},
    {"camera", "", "camera view"},
    {"camera_options", "", "camera options that differ from the defaults, as JSON"},
    {"width_px", "pixels", "width of the frames"},
    {"height_px", "pixels", "height of the frames"},
    {"fps", "1/s", "frames per second"},
    {"cycles", "",
     "repetitions of a looping motion; films end earlier where durations are equalized"},
    {"in_place", "0/1", "1: walking in place, as on a treadmill"},
    {"quality", "", "draft, standard or final"},
    {"samples_per_pixel", "", "samples per pixel at that quality"},
    {"shutter_deg", "°", "shutter angle, of 360° per frame"},
    {"cycle_s", "s", "duration of one cycle; empty for motions that do not loop"},
    {"film_frames", "", "number of frames of the film"},
    {"film_s", "s", "duration of the film"},
    {"video", "", "path of the first video, relative to the study folder; all are in videos.csv"},
    {"video_s", "s", "duration of the video, including card, cross and blanks"},
    {"video_hash", "", "its XXH3-128"},
    {"clip", "", "path of the motion file, relative to the study folder"},
    {"clip_hash", "", "its XXH3-128"},
    {"frames", "", "path of the folder of frames, relative to the study folder"},
    {"frames_hash", "", "XXH3-128 of the names and hashes of all frames"},
});

inline constexpr TableForm stimuli_form = {
    "metrics/stimuli.csv", "stimulus, followed by one per overlay", stimuli_columns};

inline constexpr std::array warnings_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus or overlay; empty for warnings about the examples"},
    {"about", "", "examples, design (relations among stimuli), motion or film"},
    {"warning", "", "a sentence"},
});

inline constexpr TableForm warnings_form = {"metrics/warnings.csv", "warning", warnings_columns};

/// The table that all others join: how each stimulus was made and shown, and its files, as they lie
/// in the study's folder.
std::string stimuli_csv(const Manifest& manifest, Motions& motions,
                        const std::filesystem::path& folder);

/// What a run has to say about examples, design, motions and films; of these the records in the
/// study's folder tell.
std::string warnings_csv(const Manifest& manifest, Motions& motions,
                         const std::filesystem::path& folder);

}  // namespace mien::pipeline
