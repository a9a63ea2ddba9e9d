#include "pipeline/regression/wider_limits.h"

#include <algorithm>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

double limit_of(const std::string& part, const RegressionLimits& limits) {
  const auto own = std::ranges::find(limits.parts_mm, part, &std::pair<std::string, double>::first);
  return own == limits.parts_mm.end() ? limits.position_mm : own->second;
}

}  // namespace

std::vector<std::string> wider_limits(const RegressionLimits& approved,
                                      const RegressionLimits& now) {
  std::vector<std::string> wider;
  const auto compare = [&](const char* name, double RegressionLimits::*limit) {
    if (now.*limit > approved.*limit)
      wider.push_back(fmt::format("{} {:g} → {:g}", name, approved.*limit, now.*limit));
  };
  compare("position_mm", &RegressionLimits::position_mm);
  compare("turn_degrees", &RegressionLimits::turn_degrees);
  compare("speed_m_s", &RegressionLimits::speed_m_s);
  compare("contact_seconds", &RegressionLimits::contact_seconds);
  compare("slide_mm", &RegressionLimits::slide_mm);
  compare("perceptual", &RegressionLimits::perceptual);
  compare("psnr_db", &RegressionLimits::psnr_db);
  if (now.findings && !approved.findings) wider.emplace_back("findings false → true");
  for (const auto& [part, limit] : now.parts_mm) {
    if (const double before = limit_of(part, approved); limit > before)
      wider.push_back(fmt::format("{} {:g} → {:g} mm", part, before, limit));
  }
  return wider;
}

}  // namespace mien::pipeline
