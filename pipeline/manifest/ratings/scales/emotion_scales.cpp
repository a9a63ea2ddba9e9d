#include "pipeline/manifest/ratings/scales/emotion_scales.h"

namespace mien::pipeline {

ScaleSet emotion_scales() {
  ScaleSet set;
  set.name = "emotions";
  // What simulated raters go by is ours, as for the adjective pairs.
  const auto add = [&](const char* low, const char* high, const char* japanese_low,
                       const char* japanese_high,
                       std::vector<std::pair<std::string, double>> loadings) {
    set.scales.push_back({.id = std::string(low) + "-" + high,
                          .low = low,
                          .high = high,
                          .japanese_low = japanese_low,
                          .japanese_high = japanese_high,
                          .loadings = std::move(loadings)});
  };
  add("sad", "happy", "悲しい", "嬉しい", {{"activeness", 0.4}, {"valence", 0.7}});
  add("tired", "excited", "疲れた", "興奮した", {{"quickness", 0.5}, {"arousal", 0.6}});
  add("angry", "relaxed", "怒った", "くつろいだ", {{"tension", -0.6}, {"arousal", -0.5}});
  add("weak", "strong", "弱い", "強い", {{"largeness", 0.7}, {"stability", 0.3}});
  add("afraid", "confident", "怖がった", "自信のある", {{"largeness", 0.3}, {"stability", 0.6}});
  add("masculine", "feminine", "男性的な", "女性的な", {{"largeness", -0.5}, {"clearness", 0.3}});
  return set;
}

}  // namespace mien::pipeline
