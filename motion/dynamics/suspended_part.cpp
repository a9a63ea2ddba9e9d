#include "motion/dynamics/suspended_part.h"

#include <algorithm>
#include <cmath>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double step_seconds = 1.0 / 240.0;
constexpr double periodic_radians = 1e-6;
constexpr int most_cycles = 200;
constexpr double most_rest_seconds = 60.0;

struct Deflection {
  Vec3 angle = Vec3::Zero();  ///< of the part from where it is meant to be
  Vec3 speed = Vec3::Zero();  ///< of the part, radians/s
};

using Moment = SuspendedPart::Moment;

Moment between(const Moment& a, const Moment& b, double t) {
  Moment moment = a;
  moment.bone = ((1.0 - t) * a.bone + t * b.bone).normalized();
  moment.lever += t * (b.lever - a.lever);
  moment.inertia += t * (b.inertia - a.inertia);
  moment.field += t * (b.field - a.field);
  moment.least_hinge += t * (b.least_hinge - a.least_hinge);
  moment.least_outward += t * (b.least_outward - a.least_outward);
  return moment;
}

/// The part of a rotation vector that the joint allows.
Vec3 allowed(const Vec3& turn, const Vec3& hinge, const Vec3& bone) {
  return hinge.isZero() ? Vec3(turn - turn.dot(bone) * bone) : Vec3(turn.dot(hinge) * hinge);
}

/// Angular acceleration by a field, of a part that is deflected.
Vec3 pull(const Moment& moment, const Vec3& angle, const Vec3& field) {
  return (exp(angle) * moment.lever).cross(field) / moment.inertia;
}

/// Turns a part that would go into the body out again, and stops what moves it there.
void stop_at_body(Deflection& state, const Moment& moment) {
  const Vec3 bone = exp(state.angle) * moment.bone;
  const double missing = moment.least_outward - bone.dot(moment.outward);
  if (missing <= 0.0) return;
  const Vec3 axis = bone.cross(moment.outward);
  if (axis.norm() < 1e-6) return;
  const Vec3 outwards = axis.normalized();
  const Quat turn = exp(std::min(1.0, missing / axis.norm()) * outwards);
  state.angle = log(turn * exp(state.angle));
  state.angle -= state.angle.dot(moment.bone) * moment.bone;
  state.speed += std::max(0.0, -state.speed.dot(outwards)) * outwards;
}

/// A step whose force is that in its middle, with which the error falls with the step's square.
Deflection stepped(const Deflection& from, const Moment& middle, const Moment& moment,
                   const Vec3& rate, const SuspendedPart& part, double seconds) {
  const Vec3 halfway = from.angle + 0.5 * seconds * (from.speed - rate);
  const double used = halfway.norm() / part.largest;
  const double yielding = std::max(0.0, 1.0 - used * used);
  const Vec3 force = yielding * pull(middle, halfway, middle.field);
  Deflection to;
  for (int i = 0; i < 3; ++i) {
    const SpringState state =
        after({from.angle[i], from.speed[i]}, part.spring, rate[i], force[i], seconds);
    to.angle[i] = state.offset;
    to.speed[i] = state.speed;
  }
  to.angle = allowed(to.angle, part.hinge, moment.bone);
  to.speed = allowed(to.speed, part.hinge, moment.bone);
  if (to.angle.norm() > part.largest) {
    const Vec3 outwards = to.angle.normalized();
    to.angle = part.largest * outwards;
    to.speed -= std::max(0.0, to.speed.dot(outwards)) * outwards;
  }
  if (!part.hinge.isZero() && to.angle.dot(part.hinge) < moment.least_hinge) {
    to.angle = moment.least_hinge * part.hinge;
    to.speed = std::max(to.speed.dot(part.hinge), rate.dot(part.hinge)) * part.hinge;
  }
  if (!moment.outward.isZero()) stop_at_body(to, moment);
  return to;
}

/// From one frame to the next.
Deflection advanced(Deflection state, const Moment& from, const Moment& to,
                    const SuspendedPart& part, double seconds) {
  const int steps = std::max(1, static_cast<int>(std::ceil(seconds / step_seconds - 1e-9)));
  const Vec3 rate = allowed(from.rate, part.hinge, from.bone);
  for (int i = 0; i < steps; ++i) {
    state = stepped(state, between(from, to, (i + 0.5) / steps),
                    between(from, to, (i + 1.0) / steps), rate, part, seconds / steps);
  }
  return state;
}

/// At rest where the part is in balance in the first frame.
Deflection at_rest(const SuspendedPart& part, double seconds) {
  Moment resting = part.moments.front();
  resting.rate.setZero();
  Deflection state;
  for (double time = 0.0; time < most_rest_seconds; time += seconds) {
    const Deflection next = advanced(state, resting, resting, part, seconds);
    const bool rests = (next.angle - state.angle).norm() < 1e-9 && next.speed.norm() < 1e-7;
    state = next;
    if (rests) break;
  }
  return {state.angle, Vec3::Zero()};
}

}  // namespace

std::vector<Vec3> deflections(const SuspendedPart& part, double frames_per_second, bool loops) {
  const std::size_t count = part.moments.size();
  std::vector<Vec3> angles(count, Vec3::Zero());
  if (count == 0) return angles;
  const double seconds = 1.0 / frames_per_second;
  Deflection state = at_rest(part, seconds);
  for (int cycle = 0; cycle < (loops ? most_cycles : 1); ++cycle) {
    const Deflection first = state;
    for (std::size_t f = 0; f < count; ++f) {
      angles[f] = state.angle;
      if (f + 1 == count && !loops) return angles;
      state = advanced(state, part.moments[f], part.moments[(f + 1) % count], part, seconds);
    }
    if ((state.angle - first.angle).norm() < periodic_radians &&
        (state.speed - first.speed).norm() < periodic_radians * part.spring.frequency)
      break;
  }
  // What is still missing to a whole cycle is spread over it.
  const Vec3 missing = state.angle - angles.front();
  for (std::size_t f = 0; f < count; ++f)
    angles[f] -= missing * (static_cast<double>(f) / static_cast<double>(count));
  return angles;
}

Vec3 static_deflection(const Moment& moment, const Vec3& hinge, const Vec3& field, double frequency,
                       double largest) {
  const Vec3 wanted =
      allowed(pull(moment, Vec3::Zero(), field), hinge, moment.bone) / (frequency * frequency);
  const double size = wanted.norm();
  if (size < 1e-12) return Vec3::Zero();
  Vec3 angle = wanted * (largest * std::tanh(size / largest) / size);
  if (!hinge.isZero() && angle.dot(hinge) < moment.least_hinge) angle = moment.least_hinge * hinge;
  return angle;
}

}  // namespace mien::motion
