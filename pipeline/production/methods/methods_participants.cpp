// Who takes part, how participants are recruited and admitted, and how answers are analysed.

#include <string>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"

namespace mien::pipeline {

namespace {

void describe_recruitment(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  const Recruitment& recruitment = asked.recruitment;
  std::string text = "The planned number of participants was " + std::to_string(asked.participants);
  if (recruitment.prolific != SessionEndTexts{}) text += "; they were recruited on Prolific";
  out.say(text);
  const Names kept = kept_parameters(recruitment);
  if (!kept.empty())
    out.say(fmt::format("Of the participants' links, the {} {} {} kept{}",
                        kept.size() == 1 ? "parameter" : "parameters", listed(kept),
                        kept.size() == 1 ? "was" : "were",
                        recruitment.pseudonymise ? " as keyed hashes only" : ""));
}

/// "from 18 to 65", "woman or other"
std::string range_words(const AnswerRange& range) {
  if (range.from && range.to) return fmt::format("from {:g} to {:g}", *range.from, *range.to);
  if (range.from) return fmt::format("{:g} or more", *range.from);
  if (range.to) return fmt::format("{:g} or less", *range.to);
  Names choices;
  for (const std::string& choice : range.choices) choices.push_back(motion::printable(choice));
  return fmt::format("{}", fmt::join(choices, " or "));
}

void describe_screening(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  const Screening& screening = asked.screening;
  Names conditions, only_asked;
  for (const ScreeningQuestion& question : screening.questions) {
    if (question.accept.empty())
      only_asked.push_back(question.id);
    else
      conditions.push_back(question.id + " (" + range_words(question.accept) + ")");
  }
  if (screening.window)
    conditions.push_back(fmt::format("a window of at least {} × {} pixels", (*screening.window)[0],
                                     (*screening.window)[1]));
  if (screening.refresh_hz)
    conditions.push_back(
        fmt::format("a screen with a refresh rate of at least {:g} Hz", *screening.refresh_hz));
  if (screening.sound) conditions.push_back("audible sound, shown by counting tones");
  if (!conditions.empty())
    out.say(fmt::format("Conditions for taking part were {}", listed(conditions)));
  out.say(asked.phones == Phones::refused ? "Phones were not admitted"
                                          : "Phones were admitted as well as computers");
  if (!only_asked.empty())
    out.say("Before the study, participants were also asked for " + listed(only_asked));
  Names quotas;
  for (const Quota& quota : screening.quotas) {
    Names who;
    for (const auto& [question, range] : quota.of)
      who.push_back(question + ": " + range_words(range));
    quotas.push_back(fmt::format("{} ({})", quota.at_most, fmt::join(who, "; ")));
  }
  if (!quotas.empty()) out.say("The numbers of participants were limited to " + listed(quotas));
}

void describe_consent(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  if (!asked.consent.text.empty())
    out.say("Participants read a text on the study and gave consent" +
            (asked.consent_version.empty()
                 ? ""
                 : " (version " + motion::printable(asked.consent_version) + ")"));
  Names questions;
  for (const Demographic& question : asked.demographics) questions.push_back(question.id);
  if (!questions.empty()) out.say("They were asked for " + listed(questions));
  if (!asked.debriefing.text.empty()) out.say("They were debriefed at the end");
}

std::string language_name(const std::string& tag) {
  constexpr std::pair<const char*, const char*> languages[] = {
      {"en", "English"}, {"ja", "Japanese"}, {"de", "German"},  {"fr", "French"},
      {"es", "Spanish"}, {"fi", "Finnish"},  {"zh", "Chinese"}, {"ar", "Arabic"}};
  const std::string language = tag.substr(0, tag.find('-'));
  for (const auto& [known, name] : languages)
    if (language == known) return name;
  return "the language " + motion::printable(tag);
}

void describe_language(MethodsText& out) {
  const PageLanguage& language = out.manifest.questionnaire->language;
  Names names;
  for (const std::string& tag : language.offered) names.push_back(language_name(tag));
  if (names.size() == 1)
    out.say("The questionnaire was in " + names.front());
  else
    out.say(
        fmt::format("The questionnaire was in {}, whichever the participant's browser "
                    "preferred",
                    listed(names)));
}

/// "α = .05"
std::string alpha_text(double alpha) {
  const std::string text = fmt::format("{:g}", alpha);
  return "α = " + (text.starts_with("0.") ? text.substr(1) : text);
}

std::string correction_text(TestCorrection correction) {
  switch (correction) {
    case TestCorrection::holm:
      return "p values were corrected within each family of tests by Holm's method";
    case TestCorrection::benjamini_hochberg:
      return "p values were corrected within each family of tests by the method of Benjamini and "
             "Hochberg";
    case TestCorrection::none:
      break;
  }
  return "p values were not corrected for multiple comparisons";
}

}  // namespace

void describe_participants(MethodsText& out) {
  describe_recruitment(out);
  describe_screening(out);
  describe_consent(out);
  describe_language(out);
}

void describe_tests(MethodsText& out) {
  const Questionnaire& asked = *out.manifest.questionnaire;
  const AnalysisPlan& plan = asked.analysis;
  out.say(fmt::format("Tests were two-sided with {}; {}", alpha_text(plan.alpha),
                      correction_text(plan.correction)));
  if (asked.attention_every > 0)
    out.say(fmt::format("Participants who failed more than {} were left out",
                        count_of(static_cast<std::size_t>(plan.max_failed_checks),
                                 "attention check", "attention checks")));
}

void describe_stated_plan(MethodsText& out) {
  const TextSource& plan = out.manifest.questionnaire->analysis.plan;
  if (plan.text.empty()) return;
  out.say("The plan of the analysis, stated before the study, was as follows");
  out.quote(plan.text);
}

}  // namespace mien::pipeline
