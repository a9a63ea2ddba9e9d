#include "pipeline/regression/stimulus_facts.h"

#include "pipeline/production/synthesis/motion_record.h"
#include "pipeline/regression/settings.h"

namespace mien::pipeline {

namespace {

/// Shares that round to nothing are none.
constexpr double least_weight = 1e-9;

NamedValues weights_of(const Synthesis& made, const Repertoire& repertoire) {
  NamedValues weights;
  for (Eigen::Index e = 0; e < made.weights.size(); ++e) {
    const double weight = made.weights[e];
    if (std::abs(weight) > least_weight)
      weights.emplace_back(repertoire.names[static_cast<std::size_t>(e)].name, weight);
  }
  return weights;
}

}  // namespace

StimulusFacts facts_of(const std::string& id, Rendition& rendition) {
  const Stimulus& stimulus = *find_stimulus(rendition.manifest(), id);
  const motion::Clip& clip = rendition.clip_of(id);
  const Synthesis& made = rendition.motions().of(id);
  StimulusFacts facts{.id = id,
                      .edition = {},
                      .origin = this_origin(),
                      .settings = settings_of(stimulus, rendition.manifest(), rendition.files()),
                      .weights = {},
                      .asked = made.asked,
                      .reached = made.reached,
                      .findings = {},
                      .motion = digest_of(clip),
                      .scene = rendition.scene_key(id),
                      .drawing = rendition.drawing_key(id),
                      .frames = clip.frame_count(),
                      .fps = clip.frames_per_second,
                      .limits = stimulus.regression,
                      .key_frames = {},
                      .videos = {}};
  if (made.weights.size() > 0) facts.weights = weights_of(made, rendition.motions().repertoire());
  for (const motion::Finding& finding : made.findings) facts.findings.push_back(finding.sentence);
  return facts;
}

}  // namespace mien::pipeline
