#pragma once

#include <Eigen/Core>

#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

struct FourierStyleOptions {
  double amount = 1.0;  ///< factor of the difference; above 1 extrapolates, below 0 inverts it
  int harmonics = 7;    ///< number of harmonics of the cycle that are changed; ≥ 1
};

/// A loop as a Fourier series in the phase φ of its cycle, 0 … 2π (Unuma, Anjyo and Takeuchi 1995):
/// θ(φ) = A₀ + Σ Aₙ sin(nφ + φₙ). The cycle's duration and the horizontal travel are stored
/// separately.
struct FourierMotion {
  MotionCurves frame;  ///< heading, means and travel, which are not in the series; its `values`
                       ///< are empty
  double cycle_seconds = 0.0;  ///< 2π/ω
  Eigen::RowVectorXd mean;     ///< A₀
  Eigen::MatrixXd amplitudes;  ///< row n−1: Aₙ ≥ 0 of all curves; radians or metres
  Eigen::MatrixXd phases;      ///< row n−1: φₙ, radians
};

/// The Fourier series of a loop with all harmonics that its frames can represent (frames / 2).
/// Rotations are relative to the given means, so that several motions can be compared. Throws Error
/// if the clip does not loop.
FourierMotion fourier_motion(const Clip& loop, const std::vector<Quat>& means);

/// Evaluates the series at the frame rate of the motion from which it was made. The duration is
/// rounded to whole frames; harmonics that these frames cannot represent are omitted.
Clip to_clip(const FourierMotion& motion);

/// The motion plus `amount` times the difference of `styled` from `neutral` (such as tired −
/// normal) in A₀, Aₙ, φₙ (through the smaller angle), cycle frequency and travel. If `motion` is
/// also `neutral`, this interpolates or extrapolates between the two. Harmonics above `harmonics`
/// are unchanged. Amplitudes are kept ≥ 0, and the frequency between a third and three times that
/// of the motion. All three clips must loop and begin at the same phase of the cycle; throws Error
/// if one does not loop. Foot plants are not restored.
Clip fourier_styled(const Clip& motion, const Clip& neutral, const Clip& styled,
                    const FourierStyleOptions& options = {});

}  // namespace mien::motion
