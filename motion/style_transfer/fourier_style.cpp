#include "motion/style_transfer/fourier_style.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "motion/error.h"

namespace mien::motion {

namespace {

using Spectrum = Eigen::MatrixXcd;

void require_loop(const Clip& clip) {
  if (clip.loops) return;
  throw Error("the motion \"" + clip.name + "\" is not cyclic, so it has no Fourier series",
              "use a gait cycle, or another method");
}

/// Factor of a cycle's n-th harmonic over `frames` frames: 2, but 1 at half the frame rate, where
/// it is a cosine only.
double harmonic_share(int n, int frames) { return 2 * n == frames ? 1.0 : 2.0; }

/// Row n−1: complex amplitude cₙ of harmonic n, θ = mean + Re Σ cₙ exp(i n φ).
Spectrum spectrum_of(const Eigen::MatrixXd& values) {
  const int frames = static_cast<int>(values.rows());
  Spectrum spectrum = Spectrum::Zero(frames / 2, values.cols());
  for (int n = 1; n <= frames / 2; ++n) {
    for (int i = 0; i < frames; ++i) {
      const double angle = 2.0 * pi * ((static_cast<long>(n) * i) % frames) / frames;
      spectrum.row(n - 1) += std::polar(harmonic_share(n, frames) / frames, -angle) *
                             values.row(i).cast<std::complex<double>>();
    }
  }
  return spectrum;
}

/// The shorter way round, radians.
double wrapped(double angle) { return std::remainder(angle, 2.0 * pi); }

}  // namespace

FourierMotion fourier_motion(const Clip& loop, const std::vector<Quat>& means) {
  require_loop(loop);
  FourierMotion motion;
  motion.frame = to_curves(loop, means);
  motion.cycle_seconds = loop.duration_seconds();
  motion.mean = motion.frame.values.colwise().mean();
  const Spectrum spectrum = spectrum_of(motion.frame.values);
  motion.amplitudes = spectrum.cwiseAbs();
  // Re(c exp(inφ)) = |c| sin(nφ + arg c + π/2).
  motion.phases = spectrum.array().arg() + 0.5 * pi;
  motion.frame.values.resize(0, curve_count);
  return motion;
}

Clip to_clip(const FourierMotion& motion) {
  MotionCurves curves = motion.frame;
  const double rate = curves.timing.frames_per_second;
  const int frames = std::max(4, static_cast<int>(std::lround(motion.cycle_seconds * rate)));
  const int held = std::min(static_cast<int>(motion.amplitudes.rows()), frames / 2);
  curves.values = motion.mean.replicate(frames, 1);
  for (int i = 0; i < frames; ++i) {
    for (int n = 1; n <= held; ++n) {
      const double angle = 2.0 * pi * ((static_cast<long>(n) * i) % frames) / frames;
      curves.values.row(i).array() +=
          motion.amplitudes.row(n - 1).array() * (motion.phases.row(n - 1).array() + angle).sin();
    }
  }
  return to_clip(curves);
}

Clip fourier_styled(const Clip& motion, const Clip& neutral, const Clip& styled,
                    const FourierStyleOptions& options) {
  if (options.harmonics < 1) {
    throw Error("a Fourier series needs at least one harmonic", "give harmonics of 1 or more");
  }
  const std::vector<Quat> means = mean_rotations(neutral);
  FourierMotion result = fourier_motion(motion, means);
  const FourierMotion from = fourier_motion(neutral, means);
  const FourierMotion to = fourier_motion(styled, means);
  const double amount = options.amount;
  result.mean += amount * (to.mean - from.mean);
  const auto rows =
      std::min({static_cast<Eigen::Index>(options.harmonics), result.amplitudes.rows(),
                from.amplitudes.rows(), to.amplitudes.rows()});
  for (Eigen::Index n = 0; n < rows; ++n) {
    const auto amplitude_step = to.amplitudes.row(n) - from.amplitudes.row(n);
    result.amplitudes.row(n) =
        (result.amplitudes.row(n) + amount * amplitude_step).cwiseMax(0.0).eval();
    for (int c = 0; c < curve_count; ++c) {
      result.phases(n, c) += amount * wrapped(to.phases(n, c) - from.phases(n, c));
    }
  }
  const double frequency = 1.0 / result.cycle_seconds;
  const double change = 1.0 / to.cycle_seconds - 1.0 / from.cycle_seconds;
  result.cycle_seconds =
      1.0 / std::clamp(frequency + amount * change, frequency / 3.0, frequency * 3.0);
  result.frame.way += amount * (to.frame.way - from.frame.way);
  return to_clip(result);
}

}  // namespace mien::motion
