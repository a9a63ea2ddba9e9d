#include "pipeline/regression/regression.h"

#include <algorithm>

#include "pipeline/manifest/own_seed.h"
#include "pipeline/regression/one_sided.h"
#include "pipeline/regression/stimulus_facts.h"
#include "pipeline/regression/verdict.h"
#include "pipeline/regression/wider_limits.h"

namespace mien::pipeline {

namespace {

/// Whether chance has a stimulus drawn that need not be.
bool is_audited(const Baseline& baseline, const std::string& id, double share) {
  constexpr std::uint64_t lots = 1'000'000;
  const std::string decision = baseline.approvals.empty() ? "" : baseline.approvals.back().when;
  const std::uint64_t lot = own_seed(baseline.approvals.size(), "audit " + decision + id) % lots;
  return static_cast<double>(lot) < share * static_cast<double>(lots);
}

void add_to_groups(std::vector<CauseGroup>& groups, const StimulusComparison& comparison) {
  for (const Attribution& cause : comparison.causes) {
    auto group = std::ranges::find_if(groups, [&](const CauseGroup& one) {
      return one.cause == cause.cause && one.root == cause.root;
    });
    if (group == groups.end()) group = groups.insert(group, {cause.cause, cause.root, {}, false});
    group->ids.push_back(comparison.id);
    group->differs = group->differs || comparison.verdict == Verdict::differs;
  }
}

}  // namespace

std::vector<CauseGroup> groups_of(const std::vector<StimulusComparison>& stimuli) {
  std::vector<CauseGroup> groups;
  for (const StimulusComparison& comparison : stimuli) add_to_groups(groups, comparison);
  std::ranges::stable_sort(groups, [](const CauseGroup& a, const CauseGroup& b) {
    if (a.differs != b.differs) return a.differs;
    return a.ids.size() > b.ids.size();
  });
  return groups;
}

int Regression::count(Verdict verdict) const {
  return static_cast<int>(std::ranges::count(stimuli, verdict, &StimulusComparison::verdict));
}

bool Regression::passes() const {
  return gate.holds() && repetitions.differing == 0 && count(Verdict::differs) == 0 &&
         count(Verdict::appeared) == 0 && count(Verdict::gone) == 0;
}

Regression regress(const ComparedStudy& study,
                   const std::map<std::string, std::vector<VideoFacts>>& videos,
                   const RegressionOptions& options, const StimulusDone& done) {
  Regression result;
  const Manifest& manifest = study.now.manifest();
  result.study = manifest.study;
  const auto asked = std::ranges::count_if(
      manifest.stimuli, [&](const Stimulus& one) { return study.compares(one.id); });
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (study.stop.stop_requested()) throw Interrupted{};
    if (!study.compares(stimulus.id)) {
      result.not_compared.push_back(stimulus.id);
      continue;
    }
    if (study.baseline.find(stimulus.id) == nullptr) {
      result.stimuli.push_back(appeared(stimulus.id, study));
    } else {
      StimulusFacts facts = facts_of(stimulus.id, study.now);
      if (const auto made = videos.find(stimulus.id); made != videos.end())
        facts.videos = made->second;
      const StimulusFacts& approved = *study.baseline.find(stimulus.id);
      if (!facts.videos.empty() && approved.videos.empty())
        result.without_videos.push_back(stimulus.id);
      const bool audit = is_audited(study.baseline, stimulus.id, options.audit_share);
      result.stimuli.push_back(compare(facts, study, audit));
      judge(result.stimuli.back(), stimulus.regression);
      for (const std::string& wider : wider_limits(approved.limits, stimulus.regression))
        result.wider[wider].push_back(stimulus.id);
      result.audited += int{audit};
    }
    if (done)
      done(static_cast<double>(result.stimuli.size()) / static_cast<double>(asked),
           result.stimuli.back());
  }
  for (const StimulusFacts& facts : study.baseline.stimuli) {
    if (find_stimulus(manifest, facts.id) != nullptr) continue;
    if (study.compares(facts.id)) {
      result.stimuli.push_back(gone(facts, study, result.stimuli));
    } else {
      result.not_compared.push_back(facts.id);
    }
  }
  result.groups = groups_of(result.stimuli);
  result.gate = plant_defects(study);
  return result;
}

}  // namespace mien::pipeline
