#include "pipeline/regression/one_sided.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/text/shell_word.h"
#include "pipeline/production/synthesis/motion_record.h"
#include "pipeline/regression/approved_frames.h"

namespace mien::pipeline {

namespace {

/// A stimulus that is shown by one picture alone, which is laid over none.
FrameComparison lone_frame(int frame) {
  return {.frame = frame, .same = false, .same_size = false};
}

/// Whether a clip is the approved one but for the name that a stimulus gives it.
bool is_motion_of(const StimulusFacts& approved, motion::Clip clip) {
  if (digest_of(clip) == approved.motion) return true;
  clip.name = approved.id;
  return digest_of(clip) == approved.motion;
}

/// The one that is gone and looked the same, if any.
const StimulusFacts* former(const std::string& id, const ComparedStudy& study) {
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
  comparison.frames = {lone_frame(middle)};
}

}  // namespace

StimulusComparison appeared(const std::string& id, const ComparedStudy& study) {
  StimulusComparison comparison{.id = id, .verdict = Verdict::appeared};
  const StimulusFacts* before = former(id, study);
  if (before != nullptr) {
    comparison.former_id = before->id;
    comparison.reasons.push_back(
        fmt::format("was called {}: the motion and the scene are the same", before->id));
  }
  comparison.reasons.push_back(
      fmt::format("is not in the baseline; when it is as it should be: mien regress approve {} "
                  "--only {} --why \"…\"",
                  motion::shell_path(study.now.manifest().file.string()), id));
  show_now(comparison, study);
  return comparison;
}

StimulusComparison gone(const StimulusFacts& approved, const ComparedStudy& study,
                        const std::vector<StimulusComparison>& others) {
  StimulusComparison comparison{.id = approved.id, .verdict = Verdict::gone};
  comparison.reasons.emplace_back(
      "is in the baseline, and not in the manifest any more: approve it too, and it goes");
  const auto heir = std::ranges::find(others, approved.id, &StimulusComparison::former_id);
  if (heir != others.end())
    comparison.reasons.push_back(
        fmt::format("is called {} now: the motion and the scene are the same", heir->id));
  if (study.pictures == nullptr || approved.key_frames.empty()) return comparison;
  const int frame = approved.key_frames[approved.key_frames.size() / 2].frame;
  study.pictures->put_before(approved.id, frame,
                             approved_picture(study.baseline, approved.id, frame));
  comparison.frames = {lone_frame(frame)};
  return comparison;
}

}  // namespace mien::pipeline
