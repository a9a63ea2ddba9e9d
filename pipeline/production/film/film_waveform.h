#pragma once

#include <string>

#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_sound.h"

namespace mien::pipeline {

/// Returns the path of the picture of a film's sound in the store: "sheets/sound/walk.svg".
std::string waveform_path(const std::string& stimulus);

/// Returns a picture (SVG) of the waveform of a video's sound over time, with lines where the film
/// begins and ends and where its last picture begins to be held, and the sound's loudness and true
/// peak. `fps`: frames per second.
std::string waveform_svg(const FilmSound& sound, const PresentationFrames& frames, double fps);

}  // namespace mien::pipeline
