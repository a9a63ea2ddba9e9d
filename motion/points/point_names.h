#pragma once

#include <string>
#include <vector>

namespace mien::motion {

/// Names that all differ and of which none is empty, as PointRecording requires: an empty name
/// becomes "point_3" by its place from 1, and of names that occur again the later ones get a number
/// ("LASI", "LASI_2"). A sentence is added to `notes` for each of the two that occurred.
std::vector<std::string> distinct_point_names(std::vector<std::string> names,
                                              std::vector<std::string>& notes);

}  // namespace mien::motion
