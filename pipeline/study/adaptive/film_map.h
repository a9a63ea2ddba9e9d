#pragma once

#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/adaptive/film_tables.h"

namespace mien::pipeline {

/// A map of what is known: all films that can be made, in the plane of the first two principal
/// components of their parameters (film_plane.h). A large panel names the rated and the chosen
/// films; two small ones for each scale show the expected mean rating of each film and its standard
/// deviation. The rounds are listed beside. A label for which there is no room is left out, and the
/// number of these is stated. `choice` must outlive the plot.
Plot film_map_plot(const FilmChoice& choice);

}  // namespace mien::pipeline
