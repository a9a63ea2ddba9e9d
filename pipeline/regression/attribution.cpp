#include "pipeline/regression/attribution.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/ranges.h>

namespace mien::pipeline {

namespace {

std::string joined(const std::vector<std::string>& parts) {
  return fmt::to_string(fmt::join(parts, "; "));
}

std::vector<std::string> changes_of(Aspect aspect, const std::vector<Setting>& before,
                                    const std::vector<Setting>& now) {
  std::vector<std::string> texts;
  for (const SettingChange& change : changes_between(before, now))
    if (change.aspect == aspect) texts.push_back(change_text(change));
  return texts;
}

/// Hashes are long; their beginning distinguishes them.
std::string short_hash(const std::string& hash) { return hash.substr(0, 8); }

std::vector<std::string> library_changes(const Origin& before, const Origin& now) {
  std::vector<std::string> texts;
  for (const auto& [name, version] : now.libraries) {
    const auto old = before.libraries.find(name);
    if (old == before.libraries.end()) {
      texts.push_back(name + " " + version + " is new");
    } else if (old->second != version) {
      texts.push_back(name + " " + old->second + " → " + version);
    }
  }
  for (const auto& [name, version] : before.libraries)
    if (!now.libraries.contains(name)) texts.push_back(name + " " + version + " was removed");
  if (before.processor != now.processor)
    texts.push_back("processor " + before.processor + " → " + now.processor);
  return texts;
}

/// Changes of program and machine; `code` is the cause for changes of mien's own code.
std::vector<Attribution> origin_causes(const StimulusStates& states, Cause code,
                                       const std::string& code_before, const std::string& code_now,
                                       const std::string& evidence) {
  std::vector<Attribution> causes;
  if (code_before != code_now)
    causes.push_back(
        {code,
         fmt::format("mien {} ({}) → {} ({})", states.approved.origin.program,
                     short_hash(code_before), states.now.origin.program, short_hash(code_now)),
         evidence,
         {}});
  const auto changed = library_changes(states.approved.origin, states.now.origin);
  if (!changed.empty()) causes.push_back({Cause::environment, joined(changed), evidence, {}});
  if (causes.empty())
    causes.push_back(
        {Cause::unknown,
         "the same program, libraries and files",
         evidence + "; no known change: nondeterminism in the program, or a damaged baseline",
         {}});
  return causes;
}

/// Files and options of the baseline's manifest that are read differently now.
std::vector<std::string> lost(const StimulusStates& states, Aspect aspect) {
  return changes_of(aspect, states.approved.settings, states.then.settings);
}

Attribution encoder_cause(const StimulusFacts& before, const StimulusFacts& now) {
  const auto ffmpeg = [](const StimulusFacts& facts) {
    const auto found = facts.origin.libraries.find("FFmpeg");
    return found == facts.origin.libraries.end() ? std::string() : found->second;
  };
  std::string root = joined(changes_of(Aspect::video, before.settings, now.settings));
  if (root.empty() && ffmpeg(before) != ffmpeg(now))
    root = "FFmpeg " + ffmpeg(before) + " → " + ffmpeg(now);
  if (root.empty()) root = "the encoder";
  return {Cause::encoder, root, "all key frames are identical, but the video's bytes differ", {}};
}

using Member = bool Exchanged::*;

constexpr std::array<Member, 3> members = {&Exchanged::motion, &Exchanged::scene,
                                           &Exchanged::drawing};

/// All sets of those that can be exchanged.
std::vector<Exchanged> sets_of(const Exchanged& can) {
  std::vector<Exchanged> sets = {{}};
  for (const Member member : members) {
    if (!(can.*member)) continue;
    for (std::size_t i = 0, n = sets.size(); i < n; ++i) {
      Exchanged with = sets[i];
      with.*member = true;
      sets.push_back(with);
    }
  }
  return sets;
}

int size_of(const Exchanged& set) { return int{set.motion} + int{set.scene} + int{set.drawing}; }

double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

double shapley(Member member, const Exchanged& can, const std::map<Exchanged, double>& errors) {
  if (!(can.*member)) return 0.0;
  const int all = size_of(can);
  double sum = 0.0;
  for (const Exchanged& without : sets_of(can)) {
    if (without.*member) continue;
    Exchanged with = without;
    with.*member = true;
    const int before = size_of(without);
    const double weight = factorial(before) * factorial(all - before - 1) / factorial(all);
    sum += weight * (errors.at(with) - errors.at(without));
  }
  return sum;
}

}  // namespace

std::string requested_changes(const StimulusStates& states, Aspect aspect) {
  std::vector<std::string> own, all;
  for (const SettingChange& change : changes_between(states.then.settings, states.now.settings)) {
    all.push_back(change_text(change));
    if (change.aspect == aspect) own.push_back(all.back());
  }
  if (!own.empty()) return joined(own);
  return all.empty() ? "equalization across the study's stimuli" : joined(all);
}

std::vector<Attribution> motion_causes(const StimulusStates& states) {
  std::vector<Attribution> causes;
  if (states.is_motion_remade()) {
    const auto files = lost(states, Aspect::motion);
    if (!files.empty()) {
      causes.push_back({Cause::motion,
                        joined(files),
                        "a file from which the approved motion was made has changed",
                        {}});
    } else {
      causes = origin_causes(states, Cause::synthesis, states.approved.origin.motion_code,
                             states.now.origin.motion_code,
                             "made again from the approved inputs, the motion differs");
    }
  }
  if (states.is_motion_requested())
    causes.push_back(
        {Cause::motion,
         requested_changes(states, Aspect::motion),
         "with this program, the approved and the current specification give different motions",
         {}});
  return causes;
}

std::vector<Attribution> program_causes(const StimulusStates& states) {
  const auto files = lost(states, Aspect::scene);
  if (states.is_scene_remade() && !files.empty())
    return {{Cause::scene,
             joined(files),
             "a file from which the approved scene was made has changed",
             {}}};
  return origin_causes(states, Cause::renderer, states.approved.origin.film_code,
                       states.now.origin.film_code,
                       "rendered again from the approved motion and scene, the image differs");
}

std::vector<Attribution> video_causes(const StimulusFacts& before, const StimulusFacts& now,
                                      const std::vector<VideoChange>& videos) {
  const std::string settings = joined(changes_of(Aspect::video, before.settings, now.settings));
  if (!std::ranges::all_of(videos, &VideoChange::is_made)) {
    constexpr char evidence[] = "a video that was approved is no longer made";
    if (settings.empty()) return {{Cause::unknown, "no option has changed", evidence, {}}};
    return {{Cause::presentation, settings, evidence, {}}};
  }
  const std::vector<Attribution> presentation = presentation_causes(before, now, videos);
  if (!presentation.empty()) return presentation;
  const bool shows_others = std::ranges::any_of(
      videos, [](const VideoChange& video) { return !video.same_pictures.value_or(true); });
  if (!shows_others) return {encoder_cause(before, now)};
  constexpr char evidence[] = "all key frames are identical, but a video shows other frames";
  if (!settings.empty()) return {{Cause::presentation, settings, evidence, {}}};
  return origin_causes({before, before, now}, Cause::renderer, before.origin.film_code,
                       now.origin.film_code, evidence);
}

std::vector<Attribution> presentation_causes(const StimulusFacts& before, const StimulusFacts& now,
                                             const std::vector<VideoChange>& videos) {
  const bool may_show_others = std::ranges::any_of(
      videos, [](const VideoChange& video) { return !video.same_pictures.value_or(false); });
  std::vector<std::string> changes;
  for (const SettingChange& change : changes_between(before.settings, now.settings))
    if (is_of_presentation(change.path)) changes.push_back(change_text(change));
  if (!may_show_others || changes.empty()) return {};
  return {{Cause::presentation,
           joined(changes),
           "a video shows something else around the film, or the film with other fades",
           {}}};
}

CauseShares cause_shares(const Exchanged& can, double program_error,
                         const std::function<double(const Exchanged&)>& error_of) {
  std::map<Exchanged, double> errors;
  for (const Exchanged& set : sets_of(can)) errors[set] = set == Exchanged{} ? 0.0 : error_of(set);
  const double total = program_error + errors.at(can);
  if (!(total > 0.0)) return {};
  CauseShares shares{.program = program_error / total,
                     .motion = shapley(&Exchanged::motion, can, errors) / total,
                     .scene = shapley(&Exchanged::scene, can, errors) / total,
                     .drawing = shapley(&Exchanged::drawing, can, errors) / total};
  double alone = 0.0;
  for (const Member member : members) {
    Exchanged one;
    one.*member = can.*member;
    if (can.*member) alone += errors.at(one);
  }
  shares.interaction = (errors.at(can) - alone) / total;
  return shares;
}

}  // namespace mien::pipeline
