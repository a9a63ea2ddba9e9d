#pragma once

#include <Eigen/Core>

#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

struct FourierStyleOptions {
  double amount = 1.0;  ///< of the difference; beyond 1 extrapolates, below 0 turns it round
  int harmonics = 7;    ///< of the cycle that take part; ≥ 1
};

/// A loop as a Fourier series in the phase φ of its cycle, 0 … 2π (Unuma, Anjyo and Takeuchi 1995):
/// θ(φ) = A₀ + Σ Aₙ sin(nφ + φₙ). The duration of a cycle and the way along the floor are kept
/// beside it.
struct FourierMotion {
  MotionCurves frame;          ///< what the series does not hold: heading, means, way; no values
  double cycle_seconds = 0.0;  ///< 1/ω·2π
  Eigen::RowVectorXd mean;     ///< A₀
  Eigen::MatrixXd amplitudes;  ///< row n−1: Aₙ ≥ 0 of all curves
  Eigen::MatrixXd phases;      ///< row n−1: φₙ, radians
};

/// All harmonics that the frames hold (frames / 2), about the means given, so that several motions
/// can be compared. Throws Error when the clip does not loop.
FourierMotion fourier_motion(const Clip& loop, const std::vector<Quat>& means);

/// The series at the frame rate of the motion it was made from; the duration is rounded to whole
/// frames. Harmonics beyond what these frames can hold are left out.
Clip to_clip(const FourierMotion& motion);

/// The motion plus `amount` times what distinguishes `styled` from `neutral` (tired − normal), in
/// A₀, Aₙ, φₙ (the shorter way round), frequency of cycles and way. With the motion itself as
/// neutral: interpolation between the two, and extrapolation. Harmonics beyond `harmonics` stay the
/// motion's. Amplitudes do not fall below 0, nor the frequency below a third or beyond three times
/// the motion's. All three must loop and begin at the same moment of the cycle; throws Error when
/// one does not loop. Feet are not repaired.
Clip fourier_styled(const Clip& motion, const Clip& neutral, const Clip& styled,
                    const FourierStyleOptions& options = {});

}  // namespace mien::motion
