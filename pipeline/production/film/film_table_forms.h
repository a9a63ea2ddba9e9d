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
     "frames that were looked at: all, or those of the contact sheet where neither frames nor "
     "videos are written"},
    {"mean_luminance", "0–1", "relative luminance, linear: mean of all pixels and frames"},
    {"sd_luminance", "0–1", "standard deviation over the pixels, mean of the frames"},
    {"rms_contrast", "", "standard deviation by mean, mean of the frames"},
    {"min_frame_luminance", "0–1", "mean luminance of the darkest frame"},
    {"max_frame_luminance", "0–1", "mean luminance of the lightest frame"},
    {"exposure_stops", "stops", "exposure that was added: 1 doubles the light, −1 halves it"},
});

inline constexpr std::array videos_columns = std::to_array<Column>({
    film_column,
    {"file", "", "the video, from the study's folder"},
    {"format", "", "kind of video, as output.video names it"},
    {"frames", "", "frames of the whole video"},
    {"first_film_frame", "",
     "frame of the video at which the film begins, after card, cross and blank; counted from 0"},
    {"film_frames", "", "frames of the film"},
    {"fps", "1/s", "frames a second"},
    {"duration_s", "s", "duration of the whole video"},
    {"identical", "0/1", "1: every decoded frame is the frame drawn"},
    {"worst_psnr_db", "dB", "lowest peak signal-to-noise ratio of a frame; empty where identical"},
    {"worst_psnr_frame", "", "that frame; empty where identical"},
    {"worst_ssim", "0–1",
     "lowest structural similarity of a frame, 1 for the same; empty where identical"},
    {"worst_ssim_frame", "", "that frame; empty where identical"},
    {"video_hash", "", "XXH3-128 of the file"},
});

inline constexpr std::array views_columns = std::to_array<Column>({
    film_column,
    {"figure_px", "pixels", "height of the standing figure in the picture"},
    {"visual_degrees", "°",
     "visual angle of that height on the screen that the camera names; empty without one"},
    {"figure_x_px", "pixels",
     "where the figure stands in the picture: the middle of its way on the floor, or of a camera "
     "that goes with it the figure's own place, how far right of the picture's middle; empty where "
     "it is behind the camera"},
    {"figure_y_px", "pixels", "likewise, below the picture's middle"},
});

inline constexpr std::array sizes_columns = std::to_array<Column>({
    equalized_column,
    {"framed_px", "pixels", "height of the standing figure where its camera would show it"},
    {"figure_px", "pixels", "height that it has in all films: the least of these"},
});

inline constexpr std::array places_columns = std::to_array<Column>({
    equalized_column,
    {"framed_x_px", "pixels",
     "where its camera would show the middle of its way on the floor, or of a camera that goes "
     "with it the figure's own place: right of the picture's middle"},
    {"framed_y_px", "pixels", "likewise, below the picture's middle"},
    {"x_px", "pixels", "where that place is in all films, right of the picture's middle"},
    {"y_px", "pixels", "likewise, below the picture's middle"},
});

inline constexpr std::array exposure_columns = std::to_array<Column>({
    equalized_column,
    {"mean_luminance", "0–1", "relative luminance, linear, of a few frames as they would be"},
    {"wanted_luminance", "0–1",
     "that of all films: the geometric mean of these, in which point lights that share an "
     "exposure count by their mean"},
    {"exposure_stops", "stops", "exposure that is added: 1 doubles the light, −1 halves it"},
});

inline constexpr std::array dots_columns = std::to_array<Column>({
    {"frame", "", "frame of the film, counted from 0"},
    {"time_s", "s", "time of the frame"},
    {"dot", "", "number of the dot, counted from 0; the same in all frames"},
    {"kind", "", "the joint's name, limb, noise or mask"},
    {"x_px", "pixels", "centre of the dot from the left edge; empty behind the camera"},
    {"y_px", "pixels", "centre of the dot from the upper edge, downwards"},
    {"x_m", "m", "place in the world: to the figure's left"},
    {"y_m", "m", "place in the world: up"},
    {"z_m", "m", "place in the world: the way that the figure walks"},
    {"visible", "0/1", "1: within the eye's picture"},
    {"eye", "", "both; of a stereo pair left and right, a row each"},
});

inline constexpr TableForm luminance_form = {"metrics/luminance.csv", "a film", luminance_columns};
inline constexpr TableForm videos_form = {"metrics/videos.csv", "a video", videos_columns};
inline constexpr TableForm views_form = {"metrics/views.csv", "a film", views_columns};
inline constexpr TableForm sizes_form = {"metrics/sizes.csv", "a stimulus, where size is equalized",
                                         sizes_columns};
inline constexpr TableForm places_form = {"metrics/places.csv",
                                          "a stimulus, where place is equalized", places_columns};
inline constexpr TableForm exposure_form = {
    "metrics/exposure.csv", "a stimulus, where luminance is equalized", exposure_columns};
inline constexpr TableForm dots_form = {"clips/<stimulus>.dots.csv",
                                        "a frame and dot of a point-light figure", dots_columns};

}  // namespace mien::pipeline
