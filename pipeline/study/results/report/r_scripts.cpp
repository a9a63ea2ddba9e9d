#include <set>

#include <fmt/format.h>

#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/study/results/report/dataset.h"

namespace mien::pipeline {

namespace {

/// Factors with at least two levels, of which models are made.
std::vector<std::string> varied_factors(const AnswerSet& answer_set) {
  std::vector<std::string> factors;
  const auto varies = [&](auto level_of_stimulus) {
    std::set<std::string> levels;
    for (const ReportedStimulus& stimulus : answer_set.stimuli)
      levels.insert(level_of_stimulus(stimulus));
    return levels.size() > 1;
  };
  if (varies([](const ReportedStimulus& s) { return s.made; })) factors.emplace_back("made");
  if (varies([](const ReportedStimulus& s) { return s.emotion; })) factors.emplace_back("emotion");
  if (varies([](const ReportedStimulus& s) { return s.setting; })) factors.emplace_back("setting");
  return factors;
}

/// The condition, in R, for answers on a scale (is_on_scale).
std::string on_scale_in_r() {
  std::string condition;
  for (const auto& [name, form] : trial_form_words) {
    if (!form->is_on_scale) continue;
    if (!condition.empty()) condition += " | ";
    condition += form->item.empty()
                     ? fmt::format("kind == \"{}\"", name)
                     : fmt::format("(kind == \"{}\" & item != \"{}\")", name, form->item);
  }
  return condition;
}

std::string head_of(const AnswerSet& answer_set, const std::string& what,
                    const std::string& package, const std::string& answers,
                    const std::string& stimuli) {
  return fmt::format(
      R"script(# {what} of the ratings of "{study}", scale by scale.{simulated}
#
# Run in this folder:  Rscript {package}.R
# Requires R and the package {package}:  install.packages("{package}")

suppressPackageStartupMessages(library({package}))

answers <- read.csv(file.path("..", "{answers}"), encoding = "UTF-8",
                    colClasses = c(participant = "character", session = "character",
                                   value = "character", comment = "character"))
stimuli <- read.csv(file.path("..", "{stimuli}"), encoding = "UTF-8")

# The answers analysed in the report: ratings outside practice, warm-up and checks, by
# participants who were not excluded.
counted <- subset(answers, ({on_scale}) &
                    is_practice == 0 & is_warmup == 0 & is_check == 0 &
                    excluded == 0 & !is.na(value) & value != "")
counted$value <- as.numeric(counted$value)
counted <- merge(counted, stimuli, by = "stimulus")
for (name in c("participant", "stimulus", "made", "emotion", "setting"))
  counted[[name]] <- factor(counted[[name]])

# Factors with at least two levels in the data.
wanted <- c({factors})
varied <- function(d) wanted[vapply(wanted, function(f) nlevels(droplevels(d[[f]])) > 1, TRUE)]
)script",
      fmt::arg("what", what), fmt::arg("study", answer_set.study),
      fmt::arg("simulated", answer_set.simulated ? "\n# SIMULATED answers." : ""),
      fmt::arg("package", package), fmt::arg("answers", answers), fmt::arg("stimuli", stimuli),
      fmt::arg("on_scale", on_scale_in_r()), fmt::arg("factors", [&] {
        std::string names;
        for (const std::string& factor : varied_factors(answer_set))
          names += (names.empty() ? "\"" : ", \"") + factor + "\"";
        return names;
      }()));
}

}  // namespace

RScripts r_scripts(const AnswerSet& answer_set, const std::string& answers,
                   const std::string& stimuli) {
  RScripts scripts;
  scripts.mixed = head_of(answer_set, "Linear mixed models", "lme4", answers, stimuli) +
                  R"script(
# Fixed effects: factors of the stimuli. Random effects: participants, who may favour one end of
# the scale, and stimuli, which are a sample of possible stimuli.
for (scale in unique(counted$item)) {
  d <- droplevels(subset(counted, item == scale))
  fixed <- c("1", varied(d))
  formula <- reformulate(c(fixed, "(1 | participant)", "(1 | stimulus)"), "value")
  cat("\n=====", scale, "=====\n")
  model <- lmer(formula, data = d, REML = FALSE)
  print(summary(model), correlation = FALSE)
  without <- lmer(value ~ 1 + (1 | participant) + (1 | stimulus), data = d, REML = FALSE)
  print(anova(without, model))
}
)script";
  scripts.ordinal =
      head_of(answer_set, "Cumulative link mixed models", "ordinal", answers, stimuli) +
      R"script(
# Answers as ordered categories, without assuming equal steps between them.
for (scale in unique(counted$item)) {
  d <- droplevels(subset(counted, item == scale))
  d$answer <- factor(d$value, ordered = TRUE)
  if (nlevels(d$answer) < 3) next
  fixed <- c("1", varied(d))
  formula <- reformulate(c(fixed, "(1 | participant)", "(1 | stimulus)"), "answer")
  cat("\n=====", scale, "=====\n")
  print(summary(clmm(formula, data = d, link = "logit")))
}
)script";
  return scripts;
}

}  // namespace mien::pipeline
