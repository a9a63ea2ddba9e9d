#pragma once

#include <optional>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// What a displacement curve passes through: `value` from `from` to `to` seconds (one moment if
/// they are equal), and nothing earlier than `before` seconds before that or later than `after`
/// seconds after it, unless the next key acts there.
struct CurveKey {
  double from = 0.0;
  double to = 0.0;
  Vec3 value = Vec3::Zero();
  double before = 0.5;  ///< seconds, > 0
  double after = 0.5;   ///< seconds, > 0
};

/// A smooth curve that is added to a motion (displacement mapping, Bruderlin and Williams 1995; the
/// offsets of motion warping, Witkin and Popović 1995). It passes through its keys exactly, is zero
/// outside their reach, and has continuous first and second derivatives. Between keys whose reaches
/// overlap it runs from one to the other. Of all such curves it is the one with the least integral
/// of the squared jerk (natural quintic spline; hands move between places like this: Flash and
/// Hogan 1985). It does not depend on a frame rate. In a motion that repeats after `period`
/// seconds, keys act across the seam, and no key reaches further than half of the time in which it
/// does not hold.
class DisplacementCurve {
 public:
  DisplacementCurve() = default;  ///< zero everywhere
  /// The keys may be in any order; they do not overlap, and no two are at the same moment.
  explicit DisplacementCurve(std::vector<CurveKey> keys, std::optional<double> period = {});

  /// The displacement at a time; exactly zero where no key acts.
  Vec3 at(double seconds) const;

 private:
  struct Knot {
    double seconds;
    Vec3 value;
    Vec3 slope = Vec3::Zero();
    Vec3 curvature = Vec3::Zero();
    bool is_level = true;  ///< slope and curvature are zero
  };
  struct Segment {
    std::size_t first;  ///< knot at its start; the next one is at its end
    std::size_t last;
    double width;  ///< seconds
  };

  static bool is_nothing(const Knot& knot);
  void add(const CurveKey& key);
  void connect(const std::vector<CurveKey>& keys);
  void minimize_jerk();
  Vec3 along(const Segment& segment, double seconds) const;

  std::vector<Knot> knots_;
  std::vector<Segment> segments_;
  std::optional<double> period_;
};

}  // namespace mien::motion
