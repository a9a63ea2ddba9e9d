#include <cstdio>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/fitting/fit.h"
#include "motion/gait/contact.h"
#include "motion/skeleton/sole.h"

#include "tests/motion/fitting/trc_points.h"
using namespace mien;
using namespace mien::motion;
TEST(Look, Real) {
  for (const char* name : {"walking5_markers", "subject01_walk1", "walk_free_01", "markers_walk"}) {
    auto r = test::trc_points(std::string("/work/shared/data/recordings/opensim/") + name + ".trc");
    printf("==== %s frames %d rate %.2f points %d\n", name, r.frame_count(), r.frames_per_second,
           r.point_count());
    try {
      auto f = fit_body(r);
      printf("set %s up %s floor %.3f raised %.4f resid %.1f mm\n", f.marker_set.c_str(),
             f.axes.up.c_str(), f.axes.floor, f.raised, f.residual_mm);
      for (auto& n : f.notes) printf("  note: %s\n", n.c_str());
      for (auto& n : f.warnings) printf("  WARN: %s\n", n.c_str());
      for (auto& p : f.points)
        printf("   %-16s %-28s %d res %6.1f miss %.2f fill %.2f\n", p.name.c_str(), p.role.c_str(),
               int(p.use), p.residual_mm, p.missing_share, p.filled_share);
      const auto& b = f.clip.body;
      for (int j = 1; j < 21; ++j)
        printf("   %-14s %6.3f %6.3f %6.3f |%.3f|\n", b.joints[j].name.c_str(),
               b.joints[j].offset.x(), b.joints[j].offset.y(), b.joints[j].offset.z(),
               b.joints[j].offset.norm());
      printf("   stature %.3f\n", standing_height(b) + sole_depth(b));
      double dmax[21] = {};
      int fr[21] = {};
      for (int i = 1; i < f.clip.frame_count(); ++i)
        for (int j = 0; j < 21; ++j) {
          auto a = f.clip.poses[i - 1].rotations[j], c = f.clip.poses[i].rotations[j];
          double d = a.angularDistance(c);
          if (d > dmax[j]) {
            dmax[j] = d;
            fr[j] = i;
          }
        }
      printf("   max step deg:");
      for (int j = 0; j < 21; ++j)
        printf(" %s %.1f@%d", b.joints[j].name.c_str(), dmax[j] * 57.3, fr[j]);
      printf("\n");
      double lo = 9;
      for (bool l : {true, false})
        for (auto& s : sole_paths(f.clip, l))
          lo = std::min({lo, s.heel.y(), s.ball.y(), s.tip.y()});
      printf("   lowest sole %.3f\n", lo);
      const auto& p0 = f.clip.poses.front();
      const auto& p1 = f.clip.poses.back();
      Vec3 fwd = p0.rotations[0] * Vec3::UnitZ();
      Vec3 way = p1.root_position - p0.root_position;
      printf("   facing·travel %.2f; pelvis y %.3f\n", fwd.dot(way.normalized()),
             p0.root_position.y());
      auto jp = joint_paths(f.clip);
      // knee flexion range
      for (auto [h, k, a] :
           {std::array<int, 3>{LeftHip, LeftKnee, LeftAnkle}, {RightHip, RightKnee, RightAnkle}}) {
        double mn = 999, mx = -999;
        for (auto& q : jp) {
          double c = (q[k] - q[h]).normalized().dot((q[a] - q[k]).normalized());
          double ang = std::acos(std::min(1.0, c)) * 57.3;
          mn = std::min(mn, ang);
          mx = std::max(mx, ang);
        }
        printf("   knee flex %.1f..%.1f\n", mn, mx);
      }
      double tilt = 0;
      for (auto& p : f.clip.poses) {
        Vec3 z = p.rotations[0] * Vec3::UnitZ();
        tilt += std::asin(-z.y()) * 57.3 / f.clip.frame_count();
      }
      printf("   pelvis tilt mean %.1f\n", tilt);
    } catch (const Error& e) {
      printf("ERROR %s\n", e.what());
    }
  }
}
