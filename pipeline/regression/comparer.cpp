#include "pipeline/regression/comparer.h"

#include <algorithm>
#include <utility>

#include "motion/error.h"
#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/attribution.h"
#include "pipeline/regression/rendition.h"
#include "pipeline/tasks/parallel.h"

namespace mien::pipeline {

namespace {

/// Whether frames are known to be the same without drawing them.
bool renders_identically(const StimulusFacts& before, const StimulusFacts& now) {
  return before.motion == now.motion && before.scene == now.scene &&
         before.drawing == now.drawing && before.origin.film_code == now.origin.film_code &&
         before.origin.libraries == now.origin.libraries &&
         before.origin.processor == now.origin.processor;
}

/// Compares one stimulus.
class StimulusComparer {
 public:
  StimulusComparer(const StimulusFacts& now, const ComparedStudy& study)
      : study_(study), before_(*study.baseline.find(now.id)), now_(now) {
    result_.id = now.id;
  }

  StimulusComparison compare(const ComparisonOptions& options) {
    result_.settings = changes_between(before_.settings, now_.settings);
    result_.weights = value_changes(before_.weights, now_.weights);
    result_.parameters = value_changes(before_.reached, now_.reached);
    if (options.with_videos) result_.videos = video_changes(before_.videos, now_.videos);
    const bool is_moved = before_.motion != now_.motion;
    if (is_moved) compare_motions();
    if (options.always_draw || !renders_identically(before_, now_)) {
      compare_frames();
    } else {
      result_.frames_reused = static_cast<int>(before_.key_frames.size());
    }
    if (is_moved || has_changed_pictures()) {
      find_causes();
      add_causes(presentation_causes(before_, now_, result_.videos), {});
    } else if (!result_.videos.empty()) {
      add_causes(video_causes(before_, now_, result_.videos), {});
    }
    return std::move(result_);
  }

 private:
  bool has_changed_pictures() const {
    return std::ranges::any_of(result_.frames, [](const auto& frame) { return !frame.same; });
  }

  Rendition& approved() {
    if (approved_ == nullptr) approved_ = &study_.approved(before_.edition);
    return *approved_;
  }

  const StimulusFacts& then() {
    if (!then_) then_ = facts_of(now_.id, approved());
    return *then_;
  }

  /// Whether this program can make what was approved: a file that it was made from may be gone.
  bool can_remake() {
    if (!remake_error_) {
      remake_error_ = "";
      try {
        then();
      } catch (const Error& error) {
        remake_error_ = error.what();
      }
    }
    return remake_error_->empty();
  }

  /// Where this program makes another motion of what was approved, the approved one is what it is
  /// compared with and drawn from.
  void compare_motions() {
    const motion::Clip& now = study_.now.clip_of(now_.id);
    if (!can_remake()) {
      result_.motion = motion::motion_difference(approved_clip(study_.baseline, now_.id, now), now);
      return;
    }
    if (then().motion != before_.motion)
      approved().show(now_.id, approved_clip(study_.baseline, now_.id, now));
    result_.motion = motion::motion_difference(approved().clip_of(now_.id), now);
  }

  /// The motion of now at the approved frame rate, so that frames of one number show one moment.
  /// Nothing where the rate is the same.
  const motion::Clip* clip_at_approved_rate() {
    if (before_.fps == now_.fps) return nullptr;
    if (!resampled_) resampled_ = motion::resampled(study_.now.clip_of(now_.id), before_.fps);
    return &*resampled_;
  }

  FrameSources sources(const Exchanged& exchanged) {
    Rendition& now = study_.now;
    return {.motion = exchanged.motion ? &now : &approved(),
            .scene = exchanged.scene ? &now : &approved(),
            .drawing = exchanged.drawing ? &now : &approved(),
            .clip = exchanged.motion ? clip_at_approved_rate() : nullptr};
  }

  StagedFilm staged_as(const Exchanged& exchanged) {
    return staged(now_.id, sources(exchanged), study_.threads);
  }

  /// The current film, but at the approved frame rate.
  StagedFilm staged_now() {
    Rendition& now = study_.now;
    return staged(now_.id, {&now, &now, &now, clip_at_approved_rate()}, study_.threads);
  }

  void compare_frames() {
    const StagedFilm film = staged_now();
    std::vector<int> frames;
    for (const KeyFrame& key : before_.key_frames)
      if (key.frame < film.shot.frame_count()) frames.push_back(key.frame);
    const std::vector<render::Image8> pictures = drawn(film, frames, study_.stop);
    result_.frames.resize(frames.size());
    for_each_of(frames.size(), study_.threads, study_.stop, [&](std::size_t i) {
      result_.frames[i] =
          compare_pictures(frames[i], approved_picture(frames[i]), pictures[i], /*threads=*/1);
    });
    for (std::size_t i = 0; i < frames.size(); ++i) keep(pictures[i], result_.frames[i]);
    test_for_noise(film);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      FrameComparison& frame = result_.frames[i];
      if (result_.motion && frame.noise.is_bias)
        frame.shares = shares_of(film, frame.frame, approved_picture(frame.frame), pictures[i]);
    }
  }

  /// Saves the pictures of a changed frame.
  void keep(const render::Image8& now, FrameComparison& frame) const {
    if (frame.same) return;
    if (study_.pictures != nullptr)
      study_.pictures->put(now_.id, frame.frame, approved_picture(frame.frame), now,
                           frame.perceived_map);
    frame.perceived_map = {};
  }

  void test_for_noise(const StagedFilm& film) {
    std::vector<int> changed;
    for (const FrameComparison& frame : result_.frames)
      if (!frame.same && frame.same_size) changed.push_back(frame.frame);
    const std::vector<BlockStatistics> now = measured_blocks(film, changed, study_.stop);
    auto blocks = now.begin();
    for (FrameComparison& frame : result_.frames)
      if (!frame.same && frame.same_size)
        frame.noise = noise_test(approved_blocks(frame.frame), *blocks++, suite_pictures());
  }

  render::Image8 approved_picture(int frame) const {
    return pipeline::approved_picture(study_.baseline, now_.id, frame);
  }

  BlockStatistics approved_blocks(int frame) const {
    return pipeline::approved_blocks(study_.baseline, now_.id, frame);
  }

  std::size_t suite_pictures() const {
    std::size_t count = 0;
    for (const StimulusFacts& facts : study_.baseline.stimuli) count += facts.key_frames.size();
    return count;
  }

  std::vector<BodyShare> shares_of(const StagedFilm& film, int frame, const render::Image8& before,
                                   const render::Image8& now) {
    if (!can_remake()) return {};
    const StagedFilm old = staged_as({});
    if (frame >= old.shot.frame_count()) return {};
    return body_shares(before, now,
                       {old.shot.actors.front().clip, frame, camera_at(old.shot, frame)},
                       {film.shot.actors.front().clip, frame, camera_at(film.shot, frame)});
  }

  /// The frame that differs most, as far as it is in all states.
  const FrameComparison* worst_frame() const {
    const FrameComparison* worst = nullptr;
    for (const FrameComparison& frame : result_.frames) {
      if (frame.same || !frame.same_size || frame.frame >= before_.frames) continue;
      if (worst == nullptr || frame.difference.rms > worst->difference.rms) worst = &frame;
    }
    return worst;
  }

  /// An approved motion that was read from its file is a little off, and so is what is drawn of it.
  bool is_remade_with_bias(int frame) {
    return noise_test(approved_blocks(frame),
                      measured_blocks(staged_as({}), {frame}, study_.stop).front(),
                      suite_pictures())
        .is_bias;
  }

  double squared_error(const render::Image8& a, const render::Image8& b) const {
    const double rms = render::picture_difference(a, b).rms;
    return rms * rms;
  }

  /// Causes by the manifest's settings alone, without shares.
  void guess_causes() {
    const StimulusStates states{before_, before_, now_};
    add_causes(motion_causes(states), {});
    if (states.is_scene_requested()) add_settings(Cause::scene, Aspect::scene, states, {});
    if (states.is_drawing_requested()) add_settings(Cause::drawing, Aspect::drawing, states, {});
    if (result_.causes.empty()) add_causes(program_causes(states), {});
    for (Attribution& cause : result_.causes)
      cause.evidence =
          "the approved state cannot be made again, so causes could not be isolated: " +
          remake_error_.value();
  }

  void find_causes() {
    if (!can_remake()) {
      guess_causes();
      return;
    }
    const StimulusStates states{before_, then(), now_};
    const FrameComparison* worst = worst_frame();
    const Exchanged can{before_.motion != now_.motion, states.is_scene_requested(),
                        states.is_drawing_requested()};
    CauseShares shares;
    bool is_program_a_cause = false;
    if (worst != nullptr) {
      const render::Image8 before = approved_picture(worst->frame);
      const render::Image8 none = drawn(staged_as({}), {worst->frame}, study_.stop).front();
      double program_error = squared_error(before, none);
      if (states.is_motion_remade() && !is_remade_with_bias(worst->frame)) program_error = 0.0;
      is_program_a_cause = program_error > 0.0;
      shares = cause_shares(can, program_error, [&](const Exchanged& set) {
        return squared_error(none, drawn(staged_as(set), {worst->frame}, study_.stop).front());
      });
    }
    const auto share = [&](double value) {
      return worst != nullptr ? std::optional(value) : std::nullopt;
    };
    add_causes(motion_causes(states), share(shares.motion));
    if (states.is_scene_requested())
      add_settings(Cause::scene, Aspect::scene, states, share(shares.scene));
    if (states.is_drawing_requested())
      add_settings(Cause::drawing, Aspect::drawing, states, share(shares.drawing));
    if (is_program_a_cause) add_causes(program_causes(states), share(shares.program));
    result_.interaction = shares.interaction;
    std::ranges::stable_sort(result_.causes, std::greater{},
                             [](const Attribution& one) { return one.share.value_or(0.0); });
  }

  void add_causes(std::vector<Attribution> causes, std::optional<double> share) {
    const auto count = static_cast<double>(causes.size());
    for (Attribution& cause : causes) {
      if (share) cause.share = *share / count;
      result_.causes.push_back(std::move(cause));
    }
  }

  void add_settings(Cause cause, Aspect aspect, const StimulusStates& states,
                    std::optional<double> share) {
    result_.causes.push_back({cause, requested_changes(states, aspect),
                              aspect == Aspect::scene
                                  ? "changing the scene alone changes the image"
                                  : "same motion and scene, different rendering",
                              share});
  }

  const ComparedStudy& study_;
  const StimulusFacts& before_;
  const StimulusFacts& now_;
  Rendition* approved_ = nullptr;
  std::optional<StimulusFacts> then_;
  std::optional<std::string>
      remake_error_;  ///< why the approved state cannot be made; empty if it can; set by can_remake
  std::optional<motion::Clip> resampled_;
  StimulusComparison result_;
};

}  // namespace

bool ComparedStudy::compares(const std::string& id) const {
  return only.empty() || std::ranges::find(only, id) != only.end();
}

StimulusComparison compare(const StimulusFacts& now, const ComparedStudy& study,
                           const ComparisonOptions& options) {
  return StimulusComparer(now, study).compare(options);
}

}  // namespace mien::pipeline
