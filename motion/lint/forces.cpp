#include <cmath>

#include "motion/biomechanics/inverse_dynamics.h"
#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

constexpr double least_overload_seconds = 0.1;
constexpr double light = 0.3;  // body weights; below, friction says nothing

std::vector<double> presses(const LintMotion& motion, const BodyOnFloor& body) {
  std::vector<double> values;
  for (const BodyDynamics& moment : body.moments) {
    values.push_back(moment.ground_reaction.y() / gravity);
  }
  mask_ends(motion, values);
  return values;
}

std::vector<double> pulls(const LintMotion& motion, const BodyOnFloor& body) {
  std::vector<double> values = presses(motion, body);
  for (double& value : values) value = -value;
  return values;
}

std::vector<double> frictions(const LintMotion& motion, const BodyOnFloor& body) {
  std::vector<double> values(body.moments.size(), no_value);
  for (size_t t = 0; t < values.size(); ++t) {
    const Vec3& force = body.moments[t].ground_reaction;
    if (force.y() < light * gravity) continue;
    values[t] = std::hypot(force.x(), force.z()) / force.y();
  }
  mask_ends(motion, values);
  return values;
}

/// Newton metres, a joint a row, in the order of `torque_joints`.
std::vector<std::vector<double>> torques(const LintMotion& motion, const BodyOnFloor& body,
                                         double mass_kg) {
  std::vector<std::vector<double>> rows(torque_joints().size());
  for (size_t t = 0; t < body.moments.size(); ++t) {
    const std::vector<double> values = joint_torques(body.moments[t], body.supports[t]);
    // The share of the ground reaction force on knees and hands is unknown.
    const bool is_known = body.supports[t].elsewhere.empty();
    for (size_t j = 0; j < rows.size(); ++j) {
      rows[j].push_back(is_known ? mass_kg * values[j] : no_value);
    }
  }
  for (std::vector<double>& row : rows) mask_ends(motion, row);
  return rows;
}

}  // namespace

Findings find_unnatural_forces(const LintMotion& motion, const BodyOnFloor& body,
                               const LintOptions& options, const LintMotion* original,
                               const BodyOnFloor* original_body) {
  Findings findings;
  const auto add = [&](const auto& measure, const Levels& levels, const std::string& unit,
                       const std::string& what, const std::string& after) {
    const std::vector<double> before =
        original ? measure(*original, *original_body) : std::vector<double>();
    const auto sentence = [&](double worst) { return what + rounded(worst, 1) + after; };
    add_threshold_findings(
        findings, motion,
        {"forces", "", unit, raised_levels(levels, before), least_overload_seconds, 3, sentence},
        measure(motion, body));
  };
  add(presses, options.press, "body weights", "The feet press on the floor with ",
      " times the body's weight.");
  add(pulls, options.pull, "body weights", "The body is pulled to the floor with ",
      " times the body's weight: it accelerates downwards faster than gravity.");
  add(frictions, options.friction, "", "The feet would slip: horizontal force ",
      " times the vertical force.");
  return findings;
}

Findings find_unnatural_torques(const LintMotion& motion, const BodyOnFloor& body,
                                const LintOptions& options, const LintMotion* original,
                                const BodyOnFloor* original_body) {
  Findings findings;
  const double mass = options.body_mass_kg;
  const auto rows = torques(motion, body, mass);
  const auto before = original ? torques(*original, *original_body, mass)
                               : std::vector<std::vector<double>>(rows.size());
  for (size_t j = 0; j < rows.size(); ++j) {
    const TorqueJoint& joint = torque_joints()[j];
    const double limit = joint.limit * mass / 70.0;
    const Levels levels = {limit * options.torque_ratio.warning,
                           limit * options.torque_ratio.error};
    const std::string name(name_of(BodyJoint(joint.joint)));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " would need " + rounded(worst, 0) +
             " N·m, more than the " + rounded(limit, 0) + " N·m of strong adults.";
    };
    add_threshold_findings(findings, motion,
                           {"joint-torque", name, "N·m", raised_levels(levels, before[j]),
                            least_overload_seconds, 3, sentence},
                           rows[j]);
  }
  return findings;
}

}  // namespace mien::motion
