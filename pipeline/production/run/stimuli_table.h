#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

inline constexpr std::array stimuli_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus or overlay: other tables name it so"},
    {"kind", "", "stimulus or overlay"},
    {"role", "", "target, created or reference; empty for an overlay"},
    {"factor_*", "",
     "level of a factor of the design; emotion, strength, example and clip are filled in where "
     "they are plain from the stimulus; empty where it has none"},
    {"source", "",
     "what the motion is made from: adjectives, features, weights or clip; motions for an overlay"},
    {"asked", "", "of these, what: name=value, or the file, or the motions of an overlay"},
    {"ratings", "",
     "whose ratings the motion rests on: given (by people), simulated, or none (features, weights, "
     "files)"},
    {"method", "", "how the shares of the examples were found; empty for a file"},
    {"modified", "", "what was done to the motion; empty for nothing"},
    {"modified_share", "0–1",
     "share of the strengths asked for that was kept: below 1 where on_fault reduced them"},
    {"scene", "", "the set"},
    {"figure", "", "what the motion is shown on"},
    {"figure_options", "", "how it differs from that figure's defaults, as JSON"},
    {"camera", "", "the view"},
    {"camera_options", "", "how it differs from that view's defaults, as JSON"},
    {"width_px", "pixels", "width of the frames"},
    {"height_px", "pixels", "height of the frames"},
    {"fps", "1/s", "frames a second"},
    {"cycles", "",
     "how often a looping motion is repeated; where durations are equalized the film ends earlier"},
    {"in_place", "0/1", "1: on the spot, as on a treadmill"},
    {"quality", "", "draft, standard or final"},
    {"samples_per_pixel", "", "what that is in samples"},
    {"shutter_deg", "°", "part of a frame's time, of 360°, for which the shutter is open"},
    {"cycle_s", "s", "duration of one cycle; empty where nothing loops"},
    {"film_frames", "", "frames of the film"},
    {"film_s", "s", "duration of the film"},
    {"video", "", "the first video, from the study's folder; videos.csv has all"},
    {"video_s", "s", "its duration, with card, cross and blanks"},
    {"video_hash", "", "its XXH3-128"},
    {"clip", "", "the motion as a file, from the study's folder"},
    {"clip_hash", "", "its XXH3-128"},
    {"frames", "", "folder of the film's frames, from the study's folder"},
    {"frames_hash", "", "XXH3-128 of the names and hashes of all frames"},
});

inline constexpr TableForm stimuli_form = {"metrics/stimuli.csv", "a stimulus, then one an overlay",
                                           stimuli_columns};

inline constexpr std::array warnings_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus or overlay; empty for what concerns the examples"},
    {"about", "", "examples, design (stimuli among each other), motion or film"},
    {"warning", "", "a sentence"},
});

inline constexpr TableForm warnings_form = {"metrics/warnings.csv", "a warning", warnings_columns};

/// The table that all others join: how each stimulus was made and shown, and its files, as they lie
/// in the study's folder.
std::string stimuli_csv(const Manifest& manifest, Motions& motions,
                        const std::filesystem::path& folder);

/// What a run has to say about examples, design, motions and films; of these the records in the
/// study's folder tell.
std::string warnings_csv(const Manifest& manifest, Motions& motions,
                         const std::filesystem::path& folder);

}  // namespace mien::pipeline
