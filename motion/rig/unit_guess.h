#pragma once

#include <string>

namespace mien::motion {

struct UnitGuess {
  double metres = 1.0;  ///< metres in one unit of the file
  std::string warning;  ///< empty if the format prescribes a plausible unit, or prescribes none and
                        ///< a known unit fits
};

/// The unit in which a figure of `height` units is 1.2–2.2 m tall: metre, centimetre, millimetre,
/// inch, the CMU unit (0.0254/0.45 m), decimetre or foot, tried in this order. Some formats
/// prescribe metres: their figures from 0.1 to 20 m keep that unit; for smaller and larger ones it
/// is guessed as well, with a warning. If no unit fits, the result is the unit in which the figure
/// is 1.7 m tall, with a warning. `format`: that of the recording; "gltf", "bind pose", "smpl" and
/// "mvnx" are in metres.
UnitGuess guess_unit(double height, const std::string& format);

}  // namespace mien::motion
