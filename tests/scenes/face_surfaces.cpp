#include "scenes/face_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien::test {

namespace {

using motion::Vec3;

constexpr double degree = motion::radians_per_degree;

double bell(double x, double width) { return std::exp(-(x / width) * (x / width)); }

double ramp(double x, double from, double to) {
  const double t = std::min(1.0, std::max(0.0, (x - from) / (to - from)));
  return t * t * (3.0 - 2.0 * t);
}

/// Nose and eye sockets: how far the face stands out at a point of its front.
double relief(double x, double y) {
  const double nose = 0.019 * bell(x, 0.010 + 0.25 * std::max(0.0, 0.02 - y) * 0.3) *
                      ramp(y, -0.034, -0.024) * (1.0 - ramp(y, -0.02, 0.035));
  const double sockets = 0.011 * bell(std::abs(x) - 0.031, 0.018) * bell(y - 0.022, 0.014);
  return nose - sockets;
}

/// The head in a direction, by latitude and longitude from the front to the left.
Vec3 head_point(double latitude, double longitude, const FaceShape& shape, double scale) {
  const Vec3 direction(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                       std::cos(latitude) * std::cos(longitude));
  const double down = std::max(0.0, -direction.y());
  Vec3 at(0.076 * direction.x() * (1.0 - 0.22 * down * down), 0.118 * direction.y(),
          (direction.z() > 0.0 ? 0.092 : 0.1) * direction.z() * (1.0 - 0.1 * down));
  at *= scale;
  const double front = ramp(direction.z(), 0.1, 0.5);
  at.z() += front * relief(at.x(), at.y());
  at.y() -= 0.02 * shape[jaw_open] * jaw_share(at);
  return at;
}

/// How far the front of the head stands out at a place of the face.
double front_z(double x, double y) {
  const double latitude = std::asin(std::max(-1.0, std::min(1.0, y / 0.118)));
  const double down = std::max(0.0, -std::sin(latitude));
  const double across =
      x / (0.076 * (1.0 - 0.22 * down * down) * std::max(0.2, std::cos(latitude)));
  const double cosine = std::sqrt(std::max(0.0, 1.0 - across * across));
  return 0.092 * std::cos(latitude) * cosine * (1.0 - 0.1 * down) + relief(x, y);
}

Vec3 eye_centre(double side) { return {side * 0.031, 0.022, front_z(0.031, 0.022) - 0.004}; }

/// A part of a sphere around an eye: `up` and `across` are angles from the front.
Vec3 around_eye(double side, double radius, double up, double across) {
  const Vec3 direction(std::sin(across), std::cos(across) * std::sin(up),
                       std::cos(across) * std::cos(up));
  return eye_centre(side) + radius * direction;
}

/// A round cap over the front of an eyeball.
FaceSurface cap(double side, double radius, double degrees, FaceMaterial material) {
  return {10, 24, material,
          [=](double u, double v, const FaceShape&) -> Vec3 {
            const double off = degrees * degree * v, turn = 2.0 * motion::pi * u;
            return eye_centre(side) + radius * Vec3(std::sin(off) * std::cos(turn),
                                                    std::sin(off) * std::sin(turn), std::cos(off));
          },
          side > 0.0 ? FaceBone::left_eye : FaceBone::right_eye};
}

/// The lids meet below the middle of the eye.
FaceSurface lid(double side, bool is_upper) {
  const double open = std::asin(lid_opening_m / eyeball_radius_m);
  const double closed = -0.8 * open;
  return {14, 28, skin, [=](double u, double v, const FaceShape& shape) -> Vec3 {
            const double blink = shape[side > 0.0 ? blink_left : blink_right];
            const double across = (is_upper ? 1.0 : -1.0) * (80.0 - 160.0 * u) * degree;
            const double rim = (is_upper ? 1.0 : -1.0) * open * std::sqrt(bell(across, 1.2));
            const double edge = rim + blink * (closed - rim);
            const double far = (is_upper ? 115.0 : -115.0) * degree;
            const double radius = eyeball_radius_m * (is_upper ? 1.13 : 1.11);
            return around_eye(side, radius, edge + v * (far - edge), across);
          }};
}

/// A tube along a curve whose parameter goes from −1 (right) to 1 (left).
FaceSurface tube(FaceMaterial material, std::function<Vec3(double, const FaceShape&)> curve,
                 std::function<double(double)> radius) {
  return {36, 14, material, [=](double u, double v, const FaceShape& shape) -> Vec3 {
            const double s = 2.0 * u - 1.0;
            const double turn = 2.0 * motion::pi * v;
            return curve(s, shape) + radius(s) * Vec3(0.0, -std::sin(turn), std::cos(turn));
          }};
}

/// The line between lips: corners rise, fall and go outwards.
Vec3 mouth_point(double s, double lip_offset, double jaw_share, const FaceShape& shape) {
  const double smile = shape[s > 0.0 ? smile_left : smile_right];
  const double frown = shape[s > 0.0 ? frown_left : frown_right];
  const double corner = s * s, middle = std::sqrt(std::max(0.0, 1.0 - s * s));
  const double x = 0.024 * s + 0.007 * smile * s;
  const double y = -0.054 + lip_offset * middle + 0.011 * smile * corner - 0.009 * frown * corner;
  const double z = front_z(x, y) + 0.001;
  return {x, y - 0.02 * jaw_share * shape[jaw_open] * middle, z};
}

FaceSurface lips(bool is_upper) {
  const double offset = is_upper ? 0.0032 : -0.0036;
  return tube(
      lip,
      [=](double s, const FaceShape& shape) {
        return mouth_point(s, offset, is_upper ? 0.0 : 1.0, shape);
      },
      [](double s) { return 0.0008 + 0.0034 * std::sqrt(std::max(0.0, 1.0 - s * s)); });
}

/// What is dark between the lips.
FaceSurface inside_of_mouth() {
  return {36, 8, black, [](double u, double v, const FaceShape& shape) -> Vec3 {
            const double s = 2.0 * u - 1.0;
            const Vec3 upper = mouth_point(s, 0.003, 0.0, shape);
            const Vec3 lower = mouth_point(s, -0.003, 1.0, shape);
            return upper + v * (lower - upper) + Vec3(0.0, 0.0, 0.0012);
          }};
}

FaceSurface brow(double side) {
  return tube(
      hair,
      [=](double s, const FaceShape& shape) -> Vec3 {
        const double inner = 0.5 * (1.0 - side * s);  // 1 beside the nose
        const double x = side * 0.031 + 0.018 * s;
        const double down = shape[side > 0.0 ? brow_down_left : brow_down_right];
        const double y = 0.044 + 0.003 * (1.0 - s * s) + 0.013 * shape[brow_inner_up] * inner -
                         down * (0.004 + 0.008 * inner);
        return {x, y, front_z(x, y) + 0.0012};
      },
      [](double s) { return 0.0008 + 0.0022 * std::sqrt(std::max(0.0, 1.0 - s * s)); });
}

}  // namespace

Vec3 place_of(FaceBone bone) {
  if (bone == FaceBone::head) return Vec3::Zero();
  if (bone == FaceBone::jaw) return {0.0, -0.02, -0.005};
  return eye_centre(bone == FaceBone::left_eye ? 1.0 : -1.0);
}

double jaw_share(const Vec3& at) { return ramp(-at.y(), 0.045, 0.075) * ramp(at.z(), -0.02, 0.05); }

std::vector<FaceSurface> face_surfaces() {
  std::vector<FaceSurface> surfaces = {
      {96, 120, skin,
       [](double u, double v, const FaceShape& shape) {
         return head_point((180.0 * u - 90.0) * degree, 2.0 * motion::pi * v, shape, 1.0);
       }},
      {40, 96, hair,
       [](double u, double v, const FaceShape& shape) {
         const double longitude = 2.0 * motion::pi * v;
         const double line = (10.0 + 36.0 * std::cos(longitude)) * degree;
         return head_point(line + u * (90.0 * degree - line), longitude, shape, 1.04);
       }},
      lips(true),
      lips(false),
      inside_of_mouth()};
  for (const double side : {-1.0, 1.0}) {
    surfaces.push_back(cap(side, eyeball_radius_m, 100.0, white));
    surfaces.push_back(cap(side, 1.01 * eyeball_radius_m, 27.0, iris));
    surfaces.push_back(cap(side, 1.02 * eyeball_radius_m, 12.0, black));
    surfaces.push_back(lid(side, true));
    surfaces.push_back(lid(side, false));
    surfaces.push_back(brow(side));
  }
  surfaces[3].bone = FaceBone::jaw;  // the lower lip
  return surfaces;
}

}  // namespace mien::test
