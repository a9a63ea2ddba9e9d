#include "pipeline/manifest.h"

namespace mien::pipeline {

std::vector<std::string> motions_on(const Sheet& sheet) {
  if (!sheet.stills.empty()) return sheet.stills;
  if (!sheet.gallery.empty()) return sheet.gallery;
  std::vector<std::string> motions = {sheet.target, sheet.created};
  if (!sheet.reference.empty()) motions.push_back(sheet.reference);
  return motions;
}

std::vector<MotionPair> pairs_on(const Sheet& sheet) {
  if (!sheet.stills.empty()) return {};
  if (sheet.gallery.empty()) return {{sheet.target, sheet.created}};
  std::vector<MotionPair> pairs;
  for (std::size_t i = 1; i < sheet.gallery.size(); ++i) {
    pairs.push_back({sheet.gallery.front(), sheet.gallery[i]});
  }
  return pairs;
}

}  // namespace mien::pipeline
