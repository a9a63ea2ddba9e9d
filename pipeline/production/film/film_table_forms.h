#pragma once

#include <array>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

// The columns of the tables about films. Overlays have rows like stimuli, but not in what is
// equalized.

inline constexpr Column film_column = {"stimulus", "", "id of the stimulus or overlay"};
inline constexpr Column equalized_column = {"stimulus", "", "id of the stimulus"};

inline constexpr std::array luminance_columns = std::to_array<Column>({
    film_column,
    {"frames", "",
     "number of frames measured: all, or those of the contact sheet if neither frames nor videos "
     "are written"},
    {"mean_luminance", "0–1", "mean relative luminance (linear) over all pixels and frames"},
    {"sd_luminance", "0–1", "standard deviation over pixels, averaged over frames"},
    {"rms_contrast", "", "RMS contrast: standard deviation divided by mean, averaged over frames"},
    {"min_frame_luminance", "0–1", "mean luminance of the darkest frame"},
    {"max_frame_luminance", "0–1", "mean luminance of the brightest frame"},
    {"exposure_stops", "stops", "exposure compensation: 1 doubles the light, −1 halves it"},
});

inline constexpr std::array videos_columns = std::to_array<Column>({
    film_column,
    {"file", "", "path of the video, relative to the study folder"},
    {"format", "", "video format, as in output.video"},
    {"frames", "", "number of frames of the whole video"},
    {"first_film_frame", "",
     "first frame of the film within the video, after card, cross and blank; counted from 0"},
    {"film_frames", "", "number of frames of the film"},
    {"fps", "1/s", "frames per second"},
    {"duration_s", "s", "duration of the whole video"},
    {"identical", "0/1", "1: every decoded frame is identical to the rendered frame"},
    {"worst_psnr_db", "dB", "lowest peak signal-to-noise ratio of a frame; empty where identical"},
    {"worst_psnr_frame", "", "that frame; empty where identical"},
    {"worst_ssim", "0–1",
     "lowest structural similarity of a frame, 1 for the same; empty where identical"},
    {"worst_ssim_frame", "", "that frame; empty where identical"},
    {"video_hash", "", "XXH3-128 of the file"},
});

inline constexpr std::array views_columns = std::to_array<Column>({
    film_column,
    {"figure_px", "pixels", "height of the standing figure in the image"},
    {"visual_degrees", "°",
     "visual angle of that height on the screen described by the camera; empty without one"},
    {"figure_x_px", "pixels",
     "horizontal position of the figure, to the right of the image centre: the midpoint of its "
     "path on the floor, or, for a camera that follows it, its own position; empty behind the "
     "camera"},
    {"figure_y_px", "pixels", "the same vertically, below the image centre"},
});

inline constexpr std::array sizes_columns = std::to_array<Column>({
    equalized_column,
    {"framed_px", "pixels", "height of the standing figure before equalizing"},
    {"figure_px", "pixels", "height in all films: the smallest of these"},
});

inline constexpr std::array places_columns = std::to_array<Column>({
    equalized_column,
    {"framed_x_px", "pixels",
     "horizontal position before equalizing (midpoint of the path on the floor, or, for a camera "
     "that follows the figure, its own position), to the right of the image centre"},
    {"framed_y_px", "pixels", "the same vertically, below the image centre"},
    {"x_px", "pixels", "horizontal position in all films, to the right of the image centre"},
    {"y_px", "pixels", "the same vertically, below the image centre"},
});

inline constexpr std::array exposure_columns = std::to_array<Column>({
    equalized_column,
    {"mean_luminance", "0–1", "relative luminance (linear) of sampled frames before equalizing"},
    {"wanted_luminance", "0–1",
     "luminance of all films: the geometric mean of these; point-light films that share an "
     "exposure enter by their mean"},
    {"exposure_stops", "stops", "exposure compensation: 1 doubles the light, −1 halves it"},
});

inline constexpr std::array dots_columns = std::to_array<Column>({
    {"frame", "", "frame of the film, counted from 0"},
    {"time_s", "s", "time of the frame"},
    {"dot", "", "number of the dot, counted from 0; the same in all frames"},
    {"kind", "", "joint name, limb, noise or mask"},
    {"x_px", "pixels", "centre of the dot from the left edge; empty behind the camera"},
    {"y_px", "pixels", "centre of the dot from the upper edge, downwards"},
    {"x_m", "m", "world position: to the figure's left"},
    {"y_m", "m", "world position: up"},
    {"z_m", "m", "world position: in the walking direction"},
    {"visible", "0/1", "1: inside the eye's image"},
    {"eye", "", "both; for a stereo pair left or right, one row each"},
});

inline constexpr TableForm luminance_form = {"metrics/luminance.csv", "film", luminance_columns};
inline constexpr TableForm videos_form = {"metrics/videos.csv", "video", videos_columns};
inline constexpr TableForm views_form = {"metrics/views.csv", "film", views_columns};
inline constexpr TableForm sizes_form = {"metrics/sizes.csv", "stimulus, if size is equalized",
                                         sizes_columns};
inline constexpr TableForm places_form = {"metrics/places.csv", "stimulus, if place is equalized",
                                          places_columns};
inline constexpr TableForm exposure_form = {
    "metrics/exposure.csv", "stimulus, if luminance is equalized", exposure_columns};
inline constexpr TableForm dots_form = {"clips/<stimulus>.dots.csv",
                                        "frame and dot of a point-light figure", dots_columns};

}  // namespace mien::pipeline
