#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/scales/feature_parameters.h"

namespace mien::pipeline {

namespace {

/// Whether the text is "#rrggbb"; the schema reports other values.
bool is_colour(const std::string& text) {
  return text.size() == 7 && text.find_first_not_of("0123456789abcdefABCDEF", 1) == text.npos;
}

std::string matching_path(const char* key) { return member_path("matching", key); }

/// Checks a matching experiment against the rest of its manifest.
class MatchingCheck {
 public:
  explicit MatchingCheck(const Manifest& manifest)
      : manifest_(manifest), matching_(*manifest.matching), list_(manifest.places) {}

  std::vector<Fault> faults() {
    if (manifest_.questionnaire)
      list_.add("matching", "there is also a questionnaire",
                "a manifest has one or the other; use separate manifests");
    check_targets();
    check_sliders();
    check_demographics();
    check_colours();
    return list_.take();
  }

 private:
  using Names = std::vector<std::string>;

  bool uses(const char* kind) const {
    return std::ranges::find(matching_.interfaces, kind) != matching_.interfaces.end();
  }

  void check_names(const char* key, const Names& names, const char* what, const Names& known) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string path = element_path(matching_path(key), i);
      if (!known.empty()) list_.check_known_name(path, names[i], what, known);
      if (!taken.insert(names[i]).second)
        list_.add(path, motion::in_quotes(names[i]) + " appears twice", "name it once");
    }
  }

  static bool is_in(const std::string& id, const Names& names) {
    return std::ranges::find(names, id) != names.end();
  }

  /// Target and created motion may stand in each other.
  void check_colours() {
    const auto channel = [](const std::string& colour, std::size_t at) {
      return std::stoi(colour.substr(1 + 2 * at, 2), nullptr, 16);
    };
    if (!is_colour(matching_.target_colour) || !is_colour(matching_.created_colour)) return;
    for (std::size_t at = 0; at < 3; ++at) {
      const int apart =
          channel(matching_.target_colour, at) - channel(matching_.created_colour, at);
      if (std::abs(apart) >= 32) return;
    }
    list_.add(matching_path("created_colour"),
              "no participant can tell " + matching_.created_colour + " and the target's " +
                  matching_.target_colour + " apart",
              "give the two figures different colours");
  }

  void check_targets() {
    Names ids;
    for (const Stimulus& stimulus : manifest_.stimuli) ids.push_back(stimulus.id);
    for (const Stimulus* motion : motion_sources(manifest_))
      if (!is_in(motion->id, ids)) ids.push_back(motion->id);
    check_names("targets", matching_.targets, "stimulus", ids);
    check_names("practice", matching_.practice, "stimulus", ids);
    const auto is_asked = [&](const Stimulus& stimulus) {
      return is_in(stimulus.id, matching_.practice) ||
             is_in(stimulus.id, matching_targets(manifest_));
    };
    for (const Stimulus* motion : motion_sources(manifest_))
      if (is_asked(*motion) && motion->walk)
        list_.add(member_path(motion->path, "path"),
                  "sliders make one gait cycle, but this motion walks along a path",
                  "use a target made from adjectives, features, weights or a clip");
    for (const Stimulus& stimulus : manifest_.stimuli)
      if (is_asked(stimulus) && !stimulus.people.empty())
        list_.add(member_path(stimulus.path, "people"),
                  "sliders make one motion, but this stimulus has several people",
                  "name one of them as a target, such as " + stimulus.people.front().motion.id +
                      ", or use another stimulus");
    if (matching_targets(manifest_).empty())
      list_.add("matching", "there is no target motion",
                "name stimuli as targets: […], or give stimuli role: target");
  }

  /// Groups and pairs: those without ratings are reported when the experiment is made.
  Names adjectives() const {
    const ScaleSet scales = scales_of(manifest_.scales);
    Names names;
    for (const ScaleGroup& group : scales.groups) names.push_back(group.id);
    for (const Scale& scale : scales.scales) names.push_back(scale.id);
    return names;
  }

  void check_sliders() {
    check_names("interfaces", matching_.interfaces, "interface", {});
    check_names("primary", matching_.primary, "adjective", adjectives());
    check_names("pairs_offered", matching_.offered, "adjective", adjectives());
    check_names("features", matching_.features, "feature", feature_parameter_names());
    const bool asks_adjectives = !matching_.primary.empty() || !matching_.offered.empty();
    if (asks_adjectives && !uses("adjectives"))
      list_.add(matching_path(matching_.primary.empty() ? "pairs_offered" : "primary"),
                "no interface has adjectives", "add adjectives to the interfaces");
    if (!matching_.features.empty() && !uses("features"))
      list_.add(matching_path("features"), "no interface has features",
                "add features to the interfaces");
  }

  void check_demographics() {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < matching_.demographics.size(); ++i)
      check_question_id(member_path(element_path(matching_path("demographics"), i), "id"),
                        matching_.demographics[i].id, taken, list_);
  }

  const Manifest& manifest_;
  const Matching& matching_;
  FaultList list_;
};

}  // namespace

std::vector<Fault> check_matching(const Manifest& manifest) {
  return manifest.matching ? MatchingCheck(manifest).faults() : std::vector<Fault>();
}

}  // namespace mien::pipeline
