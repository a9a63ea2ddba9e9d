#pragma once

#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The task "films": what the films' records say, as tidy CSV. It reads the products of all film
/// tasks. `manifest` outlives it.
///
/// metrics/luminance.csv, a row a stimulus: stimulus, frames (that were looked at: all, or those of
/// the contact sheet where neither frames nor videos are written), mean_luminance (relative,
/// linear, 0 … 1), sd_luminance (over the pixels, mean of the frames), rms_contrast (sd / mean,
/// mean of the frames), min_frame_luminance, max_frame_luminance, exposure_stops.
///
/// metrics/videos.csv, a row a video: stimulus, file, format, frames, first_film_frame,
/// film_frames, fps, duration_s, identical (1: every decoded frame is the frame drawn),
/// worst_psnr_db, worst_psnr_frame, worst_ssim, worst_ssim_frame (empty where identical).
///
/// metrics/views.csv, a row a stimulus: stimulus, figure_px (height of the standing figure in the
/// picture, see scenes::figure_pixels), visual_degrees (the visual angle under which it is seen on
/// the screen that its camera names; empty without one).
///
/// Overlays have rows like stimuli.
Task films_task(const Manifest& manifest, const SharedDeterminants& shared);

/// Where a film's record lies in the store.
std::string film_record_path(const std::string& stimulus);

}  // namespace mien::pipeline
