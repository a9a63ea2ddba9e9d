#pragma once

#include <string>

namespace mien::motion {

struct UnitGuess {
  double metres = 1.0;  ///< metres in one unit of the file
  std::string warning;  ///< empty when one of the known units fits
};

/// The unit in which a figure `height` units tall stands 1.2–2.2 m: metre, centimetre, millimetre,
/// inch, the CMU unit (0.0254/0.45 m), decimetre or foot, tried in this order. glTF files are in
/// metres by their standard: figures from 0.1 to 20 m keep it, dolls and giants too; others are
/// guessed as well, with a warning. When nothing fits, the unit that makes the figure 1.7 m tall,
/// with a warning.
UnitGuess guess_unit(double height, const std::string& format);

}  // namespace mien::motion
