#pragma once

#include <string>
#include <vector>

namespace mien::motion {

/// The speed factor at one moment of a motion.
struct TempoPoint {
  double share = 0.0;   ///< the moment in the original: 0 its beginning … 1 its end
  double factor = 1.0;  ///< 0.25–4

  friend bool operator==(const TempoPoint&, const TempoPoint&) = default;
};

/// Speed of a motion: one factor, or a curve of factors.
struct Tempo {
  double factor = 1.0;            ///< 0.25–4; the duration is divided by it
  std::vector<TempoPoint> curve;  ///< shares ascending; if there are points, they replace `factor`

  Tempo() = default;
  Tempo(double one_factor) : factor(one_factor) {}  // a number is a tempo

  friend bool operator==(const Tempo&, const Tempo&) = default;
};

/// Whether the tempo changes nothing.
bool is_unit(const Tempo& tempo);

/// The speed factor at a moment, a share of the original's duration. Between two points, the
/// logarithm of the factor follows a monotone cubic (slopes after Fritsch and Butland 1984), so
/// that the speed changes smoothly and never leaves the range of the two. Before the first point
/// and after the last, it is constant; that of a loop goes on from the last point to the first, and
/// points at both 0 and 1 count as one point with the geometric mean of their factors.
double factor_at(const Tempo& tempo, double share, bool loops);

/// The tempo at a strength: logarithms of its factors are multiplied, and kept in their range.
Tempo scaled(const Tempo& tempo, double strength);

/// What is wrong with a tempo, and how to correct it; `wrong` is empty if nothing is.
struct TempoFault {
  std::string wrong;
  std::string remedy;
  int point = -1;             ///< index of the wrong point; −1: the factor of the whole motion
  bool is_of_factor = false;  ///< the point's factor is wrong, otherwise its moment
};

TempoFault fault_of(const Tempo& tempo);

/// "0.8", or "1 → 1.4 → 0.8", the factors of a curve.
std::string text_of(const Tempo& tempo);

}  // namespace mien::motion
