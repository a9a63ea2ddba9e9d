#include "pipeline/regression/regression.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/measures/differences/motion_tolerance.h"
#include "motion/measures/distance/body_part.h"
#include "motion/text/shell_word.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/derived_seed.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/regression_limits.h"
#include "pipeline/production/synthesis/motion_record.h"
#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/comparison.h"
#include "pipeline/regression/overlay_comparison.h"
#include "pipeline/regression/rendition.h"

namespace mien::pipeline {

namespace {

constexpr double planted_turn_degrees = 1.0;
constexpr float planted_factor = 1.5f;
constexpr float planted_light = 0.01f;  // where it is black

/// A number below `count` that the baseline's last decision chooses.
std::size_t chosen(const Baseline& baseline, const std::string& what, std::size_t count) {
  const std::string decision = baseline.approvals.empty() ? "" : baseline.approvals.back().when;
  return derived_seed(baseline.approvals.size(), what + decision) % count;
}

void plant_in_motion(const ComparedStudy& study, Gate& gate) {
  const motion::Clip& clip = study.now.clip_of(gate.id);
  const std::size_t joint =
      1 + chosen(study.baseline, "joint", clip.body.joints.size() - 1);  // not the root
  motion::Clip planted = clip;
  const double turn = planted_turn_degrees * motion::radians_per_degree;
  for (motion::Pose& pose : planted.poses)
    pose.rotations[joint] =
        pose.rotations[joint] * motion::Quat(Eigen::AngleAxisd(turn, motion::Vec3::UnitX()));
  gate.motion_defect =
      fmt::format("{} turned by {:g}°", motion::part_name(static_cast<motion::BodyJoint>(joint)),
                  planted_turn_degrees);
  const motion::MotionDifference difference = motion::motion_difference(clip, planted);
  const std::vector<int> causes = motion::causes(difference);
  gate.motion_caught = causes.size() == 1 && causes.front() == static_cast<int>(joint) &&
                       !motion::excesses(difference, {}).empty();
}

void plant_in_picture(const ComparedStudy& study, int frame, Gate& gate) {
  const BlockStatistics approved = approved_blocks(study.baseline, gate.id, frame);
  BlockStatistics planted = approved;
  const std::size_t block = chosen(study.baseline, "block", approved.count() / 3);
  for (std::size_t c = 0; c < 3; ++c) {
    float& light = planted.mean[3 * block + c];
    light = planted_factor * light + planted_light;
  }
  gate.picture_defect = fmt::format("a block of {0} x {0} pixels 50 % brighter", block_pixels);
  gate.picture_caught = noise_test(approved, planted, 1).is_bias;
}

/// The frame of a stimulus without a counterpart: one picture that is compared with none.
FrameComparison single_frame(int frame) {
  return {.frame = frame, .same = false, .same_size = false};
}

/// Whether a clip equals the approved one, apart from the name that the stimulus gives it.
bool is_motion_of(const StimulusFacts& approved, motion::Clip clip) {
  if (digest_of(clip) == approved.motion) return true;
  clip.name = approved.id;
  return digest_of(clip) == approved.motion;
}

/// The approved stimulus that is gone and had the same motion and scene, if any.
const StimulusFacts* approved_before_renaming(const std::string& id, const ComparedStudy& study) {
  const Hash scene = study.now.scene_key(id);
  const auto& all = study.baseline.stimuli;
  const auto same = std::ranges::find_if(all, [&](const StimulusFacts& facts) {
    return facts.scene == scene && find_stimulus(study.now.manifest(), facts.id) == nullptr &&
           is_motion_of(facts, study.now.clip_of(id));
  });
  return same == all.end() ? nullptr : &*same;
}

void show_now(StimulusComparison& comparison, const ComparedStudy& study) {
  if (study.pictures == nullptr) return;
  const StagedFilm film =
      staged(comparison.id, {&study.now, &study.now, &study.now}, study.threads);
  const int middle = film.shot.frame_count() / 2;
  study.pictures->put_now(comparison.id, middle, drawn(film, {middle}, study.stop).front());
  comparison.frames = {single_frame(middle)};
}

/// A stimulus that is not in the baseline, with a picture of it. If an approved stimulus with the
/// same motion and scene is missing now, it is reported as renamed. Throws Error and Interrupted.
StimulusComparison appeared(const std::string& id, const ComparedStudy& study) {
  StimulusComparison comparison{.id = id, .verdict = Verdict::appeared};
  const StimulusFacts* before = approved_before_renaming(id, study);
  if (before != nullptr) {
    comparison.former_id = before->id;
    comparison.reasons.push_back(
        fmt::format("was renamed from {}: motion and scene are the same", before->id));
  }
  comparison.reasons.push_back(
      fmt::format("is not in the baseline; if it is as intended: mien regress approve {} --only {} "
                  "--reason \"…\"",
                  motion::shell_path(study.now.manifest().file.string()), id));
  show_now(comparison, study);
  return comparison;
}

/// A stimulus that is no longer in the manifest, with a picture of it. `others` have been compared:
/// one of them may be the same stimulus, renamed. Throws Error when the baseline is damaged.
StimulusComparison gone(const StimulusFacts& approved, const ComparedStudy& study,
                        const std::vector<StimulusComparison>& others) {
  StimulusComparison comparison{.id = approved.id, .verdict = Verdict::gone};
  comparison.reasons.emplace_back(
      "is in the baseline but no longer in the manifest; approving it removes it from the "
      "baseline");
  const auto renamed = std::ranges::find(others, approved.id, &StimulusComparison::former_id);
  if (renamed != others.end())
    comparison.reasons.push_back(
        fmt::format("was renamed to {}: motion and scene are the same", renamed->id));
  if (study.pictures == nullptr || approved.key_frames.empty()) return comparison;
  const int frame = approved.key_frames[approved.key_frames.size() / 2].frame;
  study.pictures->put_before(approved.id, frame,
                             approved_picture(study.baseline, approved.id, frame));
  comparison.frames = {single_frame(frame)};
  return comparison;
}

double limit_of(const std::string& part, const RegressionLimits& limits) {
  const auto own = std::ranges::find(limits.parts_mm, part, &std::pair<std::string, double>::first);
  return own == limits.parts_mm.end() ? limits.position_mm : own->second;
}

/// Tolerances that were widened since the approval: "position_mm 1 → 50", "left hand 1 → 5 mm".
/// They are reported, so that a change cannot be hidden by widening its tolerance.
std::vector<std::string> wider_limits(const RegressionLimits& approved,
                                      const RegressionLimits& now) {
  std::vector<std::string> wider;
  const std::vector<FieldEntry> earlier = entries_of(approved, {}), current = entries_of(now, {});
  for (std::size_t i = 0; i < current.size(); ++i) {
    const OrderedJson &before = earlier[i].value, &limit = current[i].value;
    if (limit.is_number() && limit > before)
      wider.push_back(fmt::format("{} {:g} → {:g}", current[i].path, before.get<double>(),
                                  limit.get<double>()));
  }
  if (now.findings && !approved.findings) wider.emplace_back("findings false → true");
  for (const auto& [part, limit] : now.parts_mm)
    if (const double before = limit_of(part, approved); limit > before)
      wider.push_back(fmt::format("{} {:g} → {:g} mm", part, before, limit));
  return wider;
}

/// Whether a stimulus that need not be drawn is part of the random audit.
bool is_audited(const Baseline& baseline, const std::string& id, double share) {
  constexpr std::uint64_t bucket_count = 1'000'000;
  const std::string decision = baseline.approvals.empty() ? "" : baseline.approvals.back().when;
  const std::uint64_t bucket =
      derived_seed(baseline.approvals.size(), "audit " + decision + id) % bucket_count;
  return static_cast<double>(bucket) < share * static_cast<double>(bucket_count);
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

Gate plant_defects(const ComparedStudy& study) {
  Gate gate;
  std::vector<const StimulusFacts*> shared;
  for (const StimulusFacts& facts : study.baseline.stimuli)
    if (find_stimulus(study.now.manifest(), facts.id) != nullptr) shared.push_back(&facts);
  if (shared.empty()) return gate;
  const StimulusFacts& facts = *shared[chosen(study.baseline, "stimulus", shared.size())];
  gate.id = facts.id;
  plant_in_motion(study, gate);
  if (!facts.key_frames.empty()) plant_in_picture(study, facts.key_frames.front().frame, gate);
  return gate;
}

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
  const std::vector<const Stimulus*> sources = motion_sources(manifest);
  const auto asked = std::ranges::count_if(
      sources, [&](const Stimulus* motion) { return study.compares(motion->id); });
  for (const Stimulus* source : sources) {
    const Stimulus& stimulus = *source;
    if (study.stop.stop_requested()) throw Interrupted{};
    if (!study.compares(stimulus.id)) {
      result.not_compared.push_back(stimulus.id);
      continue;
    }
    if (study.baseline.find(stimulus.id) == nullptr) {
      result.stimuli.push_back(appeared(stimulus.id, study));
    } else {
      StimulusFacts facts = facts_of(stimulus.id, study.now);
      // The videos of a film of several people are those of the first.
      const auto made = videos.find(stimulus.id);
      if (made != videos.end()) facts.videos = made->second;
      const StimulusFacts& approved = *study.baseline.find(stimulus.id);
      if (!facts.videos.empty() && approved.videos.empty())
        result.without_videos.push_back(stimulus.id);
      const bool audit = is_audited(study.baseline, stimulus.id, options.audit_share);
      result.stimuli.push_back(
          compare(facts, study, {.always_draw = audit, .with_videos = made != videos.end()}));
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
  compare_overlays(study, videos, result);
  result.groups = groups_of(result.stimuli);
  result.gate = plant_defects(study);
  return result;
}

}  // namespace mien::pipeline
