#pragma once

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The recording on its own joints, but in metres and with +Y up, as glTF has it: a figure in
/// centimetres would be a giant of 170 m to every viewer. Unit and axes are found as for drawing
/// (`sketch`); what is no human stays as it is.
Recording in_metres(Recording recording);

}  // namespace mien::motion
