// What participants see and answer in a trial, and in which order.

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/manifest/questionnaire_pairs.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"

namespace mien::pipeline {

namespace {

/// More scales or choices than these are only counted.
constexpr std::size_t most_listed = 8;

std::string quoted(const std::string& text) { return "“" + motion::printable(text) + "”"; }

/// "the scale sad–happy", "6 scales (sad–happy, …)"
std::string scales_text(const ScaleSet& asked) {
  Names names;
  for (const Scale& scale : asked.scales) names.push_back(scale.low + "–" + scale.high);
  if (names.size() == 1) return "the scale " + names.front();
  const std::string count = fmt::format("{} scales", names.size());
  return names.size() > most_listed ? count : fmt::format("{} ({})", count, fmt::join(names, ", "));
}

std::string choices_text(const Manifest& manifest) {
  Names shown;
  for (const auto& [id, label] : questionnaire_choices(manifest))
    shown.push_back(motion::printable(label));
  return shown.size() > most_listed
             ? fmt::format("{} choices", shown.size())
             : fmt::format("{} choices ({})", shown.size(), fmt::join(shown, ", "));
}

/// How scales are answered.
void describe_scale_answers(MethodsText& out) {
  const AnswerSettings& answer = out.manifest.questionnaire->answer;
  if (answer.words) {
    out.say(answer.suggest.empty()
                ? "Answers were free words"
                : "Answers were free words, with suggestions while participants typed");
    return;
  }
  std::string text = answer.slider ? "Scales were sliders"
                                   : fmt::format("Scales had {} points, {}", answer.points,
                                                 answer.anchors ? "each with a label"
                                                                : "with labels at both ends");
  text += answer.starts_at == StartsAt::middle ? ", initially in the middle"
                                               : ", without an initial answer";
  out.say(text + (answer.side == PoleSide::random
                      ? "; the side of the high end varied between participants and scales"
                      : "; the high end was always on the right"));
}

std::string pair_text(const Manifest& manifest) {
  return pair_presentation(*manifest.questionnaire) == PairPresentation::in_turn
             ? "two films one after the other"
             : "two films side by side";
}

/// "mood: y", or the stimuli by name
std::string signal_text(const StimulusChoice& signal) {
  Names parts;
  for (const auto& [factor, levels] : signal.levels)
    parts.push_back(fmt::format("{}: {}", factor, fmt::join(levels, " or ")));
  for (const std::string& id : signal.ids) parts.push_back(id);
  return fmt::format("{}", fmt::join(parts, signal.levels.empty() ? ", " : "; "));
}

/// "4 films", "3 to 5 films"
std::string set_size_text(const std::vector<GridSet>& sets) {
  std::size_t least = sets.empty() ? 0 : sets.front().stimuli.size();
  std::size_t most = least;
  for (const GridSet& set : sets) {
    least = std::min(least, set.stimuli.size());
    most = std::max(most, set.stimuli.size());
  }
  return least == most ? count_of(most, "film", "films")
                       : fmt::format("{} to {} films", least, most);
}

std::string grid_text(const Manifest& manifest) {
  const GridSettings& grid = manifest.questionnaire->grid;
  const std::vector<GridSet> sets = grid_sets(manifest);
  const std::string made = grid.alike.empty()
                               ? "listed"
                               : "formed by stimuli with the same level of " + listed(grid.alike);
  const auto among = [](const std::string& what, const StimulusChoice& choice) {
    return is_stated(choice) ? fmt::format("; {} ({})", what, signal_text(choice)) : std::string();
  };
  return fmt::format(
      "In each trial, participants saw a set of {}, which they played one at a time as often as "
      "they liked, and rated each on a slider from 0 to 100, for {} (multiple stimuli with hidden "
      "reference and anchor, ITU-R BS.1534-3); there {}, {}{}{}",
      set_size_text(sets), scales_text(questionnaire_scales(manifest)),
      sets.size() == 1 ? "was 1 set" : fmt::format("were {} sets", sets.size()), made,
      among("the reference was shown openly and hidden among the others", grid.reference),
      among("an anchor was among them", grid.anchor));
}

/// What the mean of a trial is of: "leaves out the first 2.5 seconds".
std::string lead_text(double seconds) {
  if (seconds == 0.0) return "is of all samples";
  if (seconds == 1.0) return "leaves out the first second";
  return fmt::format("leaves out the first {:g} seconds", seconds);
}

/// "1 second", "2.5 seconds"
std::string seconds_text(double seconds) {
  return fmt::format("{:g} second{}", seconds, seconds == 1.0 ? "" : "s");
}

std::string continuous_text(const Manifest& manifest) {
  const ContinuousSettings& continuous = manifest.questionnaire->continuous;
  const std::size_t scales = questionnaire_scales(manifest).scales.size();
  return fmt::format(
      "In each trial, participants saw one film, once, and while it played moved a marker from 0 "
      "to 100 {}, for {}{}",
      continuous.input == TraceInput::keys ? "with the arrow keys"
                                           : "with a mouse, a finger or the arrow keys",
      scales_text(questionnaire_scales(manifest)),
      scales > 1 ? ", one scale after the other, each with all films" : "");
}

/// How continuous ratings are sampled, and what is made of them.
void describe_traces(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  const ContinuousSettings& continuous = asked.continuous;
  out.say(fmt::format(
      "The marker began {} when the film began, and a held arrow key moved it by {:g} per second; "
      "{}",
      continuous.start == TraceStart::low ? "at the low end" : "in the middle", continuous.speed,
      asked.answer.side == PoleSide::random
          ? "the side of the high end varied between participants and scales"
          : "the high end was always on the right"));
  out.say(fmt::format(
      "Its position was recorded at each refresh of the screen and interpolated to 10 samples per "
      "second of the film’s own time, in which stops of the film have no part; the mean of a trial "
      "{}",
      lead_text(continuous.lead)));
  const std::string reaction =
      "Continuous ratings lag behind what is seen; for annotators of emotion, delays of 1 to 6 "
      "seconds have been reported" +
      out.cite({"mariooryad2015"});
  out.say(asked.analysis.lag > 0.0
              ? reaction + fmt::format("; in the analysis, ratings were moved back by {}",
                                       seconds_text(asked.analysis.lag))
              : reaction + "; the analysis did not correct for this lag");
}

/// What is shown and asked in a trial, as a sentence without its full stop.
std::string task_text(const Manifest& manifest) {
  const Questionnaire& asked = *manifest.questionnaire;
  const TrialForm* form = asked.trials;
  const ScaleSet scales = questionnaire_scales(manifest);
  if (form == &emotion_form)
    return "In each trial, participants saw one film and answered by one of " +
           choices_text(manifest) +
           (scales.scales.empty() ? "" : ", and rated it on " + scales_text(scales));
  if (form == &pair_form)
    return fmt::format(
        "In each trial, participants saw {} and chose, for {}, the one closer to the high end{}{}",
        pair_text(manifest), scales_text(scales),
        asked.preference.ties ? "; they could also answer that there was no difference" : "",
        asked.preference.strength ? "; a preference was slight or strong" : "");
  if (!asked.adaptive.empty()) return adaptive_task_text(manifest);
  if (form == &same_different_form)
    return fmt::format(
        "In each trial, participants saw {} and said whether they were the same or different; in "
        "{:.0f} % of the trials, they were the same{}",
        pair_text(manifest), 100.0 * asked.same_different.same,
        asked.same_different.differ_in.empty()
            ? ""
            : "; different ones differed in " + asked.same_different.differ_in + " only");
  if (form == &yes_no_form)
    return fmt::format(
        "In each trial, participants saw one film and said whether the signal was present; {} of "
        "{} had the signal ({})",
        signal_stimuli(manifest).size(),
        count_of(questionnaire_stimuli(manifest).size(), "stimulus", "stimuli"),
        signal_text(asked.signal));
  if (form == &two_interval_form)
    return fmt::format(
        "In each trial, participants saw two films one after the other, one of them with the "
        "signal "
        "({}), and said which one had it",
        signal_text(asked.signal));
  if (form == &best_worst_form)
    return fmt::format(
        "In each trial, participants saw a set of {} films and chose, for {}, those closest to the "
        "high and to the low end; there {} {}, in which all stimuli occurred about equally often",
        asked.best_worst.size, scales_text(scales),
        questionnaire_subject_count(manifest) == 1 ? "was" : "were",
        count_of(questionnaire_subject_count(manifest), "set", "sets"));
  if (form == &grid_form) return grid_text(manifest);
  if (form == &continuous_form) return continuous_text(manifest);
  if (form == &rating_form && asked.answer.words)
    return "In each trial, participants saw one film and described it in words (" +
           scales_text(scales) + ")";
  if (form == &rating_form)
    return "In each trial, participants saw one film and rated it on " + scales_text(scales);
  return fmt::format("Trials were of the kind {}", form->name);
}

void describe_task(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  out.say(task_text(out.manifest));
  if (!asked.adaptive.empty()) describe_levels(out);
  if (!asked.question.empty()) out.say("The question was " + quoted(asked.question.text));
  if (asked.trials->is_continuous) describe_traces(out);
  if (asked.trials->is_on_scale && !asked.trials->is_on_slider &&
      !questionnaire_scales(out.manifest).scales.empty())
    describe_scale_answers(out);
  if (!asked.preference.alike.empty() && asked.trials == &pair_form)
    out.say("Only stimuli with the same level of " + listed(asked.preference.alike) +
            " were compared");
  if (!asked.reference.empty())
    out.say("The stimulus " + asked.reference + " was shown beside it for comparison");
  if (asked.comments) out.say("Participants could add a comment to each trial");
}

/// The viewing distance, as the rest of a sentence.
std::string distance_text(MethodsText& out) {
  const DisplaySettings& display = out.manifest.questionnaire->display;
  const std::string asked =
      fmt::format("{:g} cm, which participants were asked to keep", display.distance_cm);
  return display.blind_spot
             ? "; the viewing distance was measured with the blind spot of the eye" +
                   out.cite({"li2020"}) + " or, where this was not possible, taken as " + asked
             : "; the viewing distance was " + asked;
}

void describe_display(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  if (asked.view == ShownAs::turn) {
    out.say("Motions were shown as stick figures that participants could turn");
  } else if (!asked.trials->is_continuous) {
    std::string watching = asked.watch == Watching::full
                               ? "Answers were possible after a film had been played to its end"
                               : "Answers were possible before a film had ended";
    if (!asked.replays.most)
      watching += "; films could be replayed without limit";
    else if (*asked.replays.most == 0)
      watching += "; films could not be replayed";
    else
      watching += fmt::format("; films could be replayed {}",
                              *asked.replays.most == 1
                                  ? std::string("once")
                                  : fmt::format("up to {} times", *asked.replays.most));
    out.say(watching);
  }
  const DisplaySize& size = asked.display.size;
  const std::string calibrated = ", on a screen that participants calibrated with a bank card";
  switch (size.kind) {
    case DisplaySize::Kind::window:
      out.say("Films were as large as the window allowed");
      break;
    case DisplaySize::Kind::native:
      out.say("One pixel of a film was one pixel of the screen");
      break;
    case DisplaySize::Kind::cm:
      out.say(fmt::format("Films were {:g} cm wide{}", size.amount, calibrated) +
              distance_text(out));
      break;
    case DisplaySize::Kind::degrees:
      out.say(fmt::format("Films were {:g}° of visual angle wide{}", size.amount, calibrated) +
              distance_text(out));
      break;
  }
}

std::string order_text(const Questionnaire& asked, std::size_t scales) {
  switch (asked.order.kind) {
    case TrialOrder::Kind::fixed:
      return scales > 1 ? "Scales and trials had the same order for all participants"
                        : "Trials had the same order for all participants";
    case TrialOrder::Kind::latin:
      return "The order of trials followed a Williams square";
    case TrialOrder::Kind::blocked:
      return "Trials were blocked by " + asked.order.factor +
             ", with blocks, and trials within blocks, in random order for each participant";
    case TrialOrder::Kind::full:
      break;
  }
  return scales > 1 ? "Trials were in random order for each participant and scale"
                    : "Trials were in random order for each participant";
}

/// Trials that are not analysed: on each of several scales in turn, those of one scale.
void describe_further_trials(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  Names further;
  const auto add = [&](std::size_t count, const std::string& what, const std::string& several) {
    if (count > 0) further.push_back(count_of(count, what, several));
  };
  add(asked.trials == &grid_form ? practice_grid_sets(out.manifest).size()
                                 : asked.practice.size() / stimuli_per_trial(asked),
      "practice trial", "practice trials");
  add(static_cast<std::size_t>(asked.warm_up), "warm-up trial", "warm-up trials");
  add(static_cast<std::size_t>(asked.repeated), "repeated trial (test–retest)",
      "repeated trials (test–retest)");
  if (further.empty()) return;
  const bool is_one = further.size() == 1 && further.front().starts_with("1 ");
  const char* were = is_one ? "was" : "were";
  const std::size_t scales = scales_in_turn(out.manifest);
  const std::string opening =
      scales > 1 ? fmt::format("With each of the {} scales there {} in addition", scales, were)
                 : fmt::format("In addition there {}", were);
  out.say(
      fmt::format("{} {}, which {} not analysed with the others", opening, listed(further), were));
}

/// Attention checks, if there are any.
void describe_checks(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  if (asked.attention_every == 0) return;
  const int checks = attention_checks(out.manifest);
  out.say(fmt::format("About every {}, an attention check asked for a certain answer{}",
                      asked.attention_every == 1 ? std::string("trial")
                                                 : fmt::format("{} trials", asked.attention_every),
                      checks > 0 ? fmt::format(" (about {} in a session)", checks) : ""));
}

void describe_order(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  if (!asked.adaptive.empty()) {
    describe_further_trials(out);
    return describe_checks(out);
  }
  const std::size_t all = questionnaire_subject_count(out.manifest);
  const std::size_t own = asked.per_participant > 0
                              ? std::min(all, static_cast<std::size_t>(asked.per_participant))
                              : all;
  const std::string one = asked.trials->judged;
  const std::string many = one == "stimulus" ? "stimuli" : one + "s";
  out.say(own < all
              ? fmt::format("Each participant saw {} of the {}, which were shared out so that "
                            "all were seen about equally often",
                            own, count_of(all, one, many))
          : all == 1 ? fmt::format("Each participant saw the one {}", one)
          : all == 2 ? fmt::format("Each participant saw both {}", many)
                     : fmt::format("Each participant saw all {} {}", all, many));
  const std::size_t scales = scales_in_turn(out.manifest);
  std::string order = order_text(asked, scales);
  if (!asked.no_repeats.empty())
    order += fmt::format("; successive trials differed in {}", listed(asked.no_repeats));
  out.say(order);
  if (scales > 1 && asked.order.kind != TrialOrder::Kind::fixed)
    out.say(
        "The order of the scales rotated between participants: over as many participants as there "
        "are scales, each scale was once in each place");
  describe_further_trials(out);
  describe_checks(out);
}

}  // namespace

void describe_trials(MethodsText& out) {
  describe_task(out);
  describe_display(out);
  describe_order(out);
}

}  // namespace mien::pipeline
