#include <algorithm>
#include <cmath>

#include "motion/gait/contact.h"
#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

constexpr double shortest_plant = 0.2;  // s; a shorter one that is lost is no fault

/// A plant of the original in frames of the motion.
struct ExpectedPlant {
  bool left;
  double first;
  double last;
  bool has_start;  ///< begins after the motion did
  bool has_end;    ///< ends before the motion did
};

std::vector<ExpectedPlant> expected_plants(const LintMotion& motion, const LintMotion& original) {
  std::vector<ExpectedPlant> plants;
  for (const FootPlant& plant : foot_plants(original.clip)) {
    const auto here = [&](int frame) { return corresponding_frame(original, frame, motion); };
    const int end = original.frame_count() - 1;
    const ExpectedPlant expected = {plant.left, here(plant.first), here(plant.last),
                                    plant.first > 0, plant.last < end};
    const bool is_whole = expected.has_start && expected.has_end;
    if (!motion.was_loop || is_whole) plants.push_back(expected);
  }
  return plants;
}

/// The plant of the same foot that shares most of the time; null when none does.
const FootPlant* counterpart(const ExpectedPlant& expected, const std::vector<FootPlant>& plants) {
  const FootPlant* best = nullptr;
  double most = 0.0;
  for (const FootPlant& plant : plants) {
    if (plant.left != expected.left) continue;
    const double shared =
        std::min<double>(plant.last, expected.last) - std::max<double>(plant.first, expected.first);
    if (shared > most) {
      most = shared;
      best = &plant;
    }
  }
  return best;
}

struct ContactFault {
  ExpectedPlant expected;
  double seconds;
  std::string what;  ///< "comes down", …
};

void add_fault(const LintMotion& motion, const Levels& levels, const ContactFault& fault,
               Findings& findings) {
  if (!(fault.seconds > levels.warning)) return;
  Finding finding = graded_finding("contact-timing", fault.seconds, "s", levels);
  finding.joint = name_of(fault.expected.left ? LeftAnkle : RightAnkle);
  finding.first = static_cast<int>(std::lround(fault.expected.first));
  finding.last = static_cast<int>(std::lround(fault.expected.last));
  finding.sentence =
      std::string("The ") + (fault.expected.left ? "left" : "right") + " foot " + fault.what;
  add_finding(findings, motion, std::move(finding));
}

std::string shifted(const char* what, double seconds) {
  return std::string(what) + " " + rounded(std::abs(seconds), 2) + " s " +
         (seconds > 0.0 ? "later" : "earlier") + " than in the original.";
}

}  // namespace

Findings find_shifted_contacts(const LintMotion& motion, const LintOptions& options,
                               const LintMotion& original) {
  Findings findings;
  const std::vector<FootPlant> plants = foot_plants(motion.clip);
  const Levels& levels = options.contact_shift_seconds;
  const double end = motion.frame_count() - 1.0;
  const double seconds = pace(motion, original) / motion.rate();  // of the original, a frame
  for (const ExpectedPlant& expected : expected_plants(motion, original)) {
    const double duration = (expected.last - expected.first) * seconds;
    const FootPlant* plant = counterpart(expected, plants);
    if (!plant) {
      if (duration < shortest_plant) continue;
      add_fault(motion, levels,
                {expected, duration, "is not planted where it was in the original."}, findings);
      continue;
    }
    const double start_shift = (plant->first - expected.first) * seconds;
    const double end_shift = (plant->last - expected.last) * seconds;
    if (expected.has_start && plant->first > 0) {
      add_fault(motion, levels,
                {expected, std::abs(start_shift), shifted("comes down", start_shift)}, findings);
    }
    if (expected.has_end && plant->last < end) {
      add_fault(motion, levels,
                {expected, std::abs(end_shift), shifted("leaves the floor", end_shift)}, findings);
    }
  }
  return findings;
}

}  // namespace mien::motion
