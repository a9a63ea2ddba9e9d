#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/study/results/report/dataset.h"

namespace mien::pipeline {

namespace {

/// A string in R.
std::string quoted_in_r(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n') {
      quoted += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/// "c("a", "b")"
std::string vector_in_r(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  for (const std::string& text : texts) quoted.push_back(quoted_in_r(text));
  return fmt::format("c({})", fmt::join(quoted, ", "));
}

/// Names of variables in R for the factors of the crossing and the question that forms groups:
/// letters, digits and '_', each different and unlike the other variables of the scripts.
std::vector<std::string> names_in_r(const std::vector<std::string>& names) {
  std::set<std::string> taken = {"answer", "excluded", "key",   "TRUE", "FALSE", "NULL", "NA", "if",
                                 "else",   "for",      "while", "in",   "next",  "T",    "F"};
  for (std::string& column : header_of(answer_form)) taken.insert(std::move(column));
  std::vector<std::string> own;
  for (const std::string& name : names) {
    std::string variable;
    for (const char c : name)
      variable += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    if (variable.empty() || std::isalpha(static_cast<unsigned char>(variable[0])) == 0)
      variable = "f" + variable;
    while (!taken.insert(variable).second) variable += "_";
    own.push_back(variable);
  }
  return own;
}

/// One line, for a comment.
std::string comment_text(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
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

/// Scales with their groups of participants in the analysis of variance: c("slow-fast woman", …)
std::string analysed_groups_in_r(const Results& results) {
  std::vector<std::string> groups;
  for (const ScaleEffects& scale : results.effects.scales)
    for (const std::string& group : scale.groups)
      groups.push_back(results.answer_set.scales[scale.scale].id + " " + group);
  return vector_in_r(groups);
}

/// The design as the scripts see it: that of the report's analysis of variance or, if there is
/// none, the levels of made, emotion and setting of all stimuli, without interactions.
struct DesignInR {
  const Results& results;
  std::vector<std::string> factors;  ///< names of variables
  std::string group;                 ///< the same; empty without groups
  bool is_crossed = false;
  bool has_random_stimuli = true;  ///< there are several stimuli in a cell

  explicit DesignInR(const Results& of) : results(of), is_crossed(!of.effects.crossing.empty()) {
    const FactorEffects& effects = of.effects;
    if (!is_crossed) {
      use_all_stimuli();
      return;
    }
    std::vector<std::string> names = factor_names(of.answer_set.factors, effects.crossing);
    const bool has_groups = !effects.between.empty() && !of.demographics.empty();
    if (has_groups) names.push_back(effects.between);
    factors = names_in_r(names);
    if (has_groups) {
      group = factors.back();
      factors.pop_back();
    }
    has_random_stimuli = effects.crossing.stimuli() > effects.crossing.cells.size();
    for (std::size_t cell = 0; cell < effects.crossing.cells.size(); ++cell) {
      for (const std::size_t stimulus : effects.crossing.cells[cell]) {
        stimuli_.push_back(of.answer_set.stimuli[stimulus].id);
        columns_.resize(factors.size());
        for (std::size_t i = 0; i < factors.size(); ++i)
          columns_[i].push_back(of.answer_set.factors.rows[stimulus][effects.crossing.factors[i]]);
      }
    }
    levels_ = effects.crossing.levels;
  }

  /// "made * emotion"
  std::string fixed() const {
    if (factors.empty()) return "1";
    const std::string within = fmt::format("{}", fmt::join(factors, is_crossed ? " * " : " + "));
    return group.empty() ? within : within + " * " + group;
  }

  /// "(1 | participant) + (1 | stimulus)"
  std::string random() const {
    std::string terms = "(1 | participant)";
    if (results.answer_set.factorial.random_slopes && !factors.empty())
      terms = fmt::format("(1 + {} | participant)", fmt::join(factors, " + "));
    return has_random_stimuli ? terms + " + (1 | stimulus)" : terms;
  }

  /// The factors for emmeans, which lets the level of the first vary fastest.
  std::string specs() const {
    return vector_in_r(std::vector<std::string>(factors.rbegin(), factors.rend()));
  }

  /// A data frame of the stimuli with their levels.
  std::string design_frame() const {
    std::string frame = "design <- data.frame(\n  stimulus = " + vector_in_r(stimuli_);
    for (std::size_t i = 0; i < factors.size(); ++i)
      frame += fmt::format(",\n  {} = factor({},\n    levels = {})", factors[i],
                           vector_in_r(columns_[i]), vector_in_r(levels_[i]));
    return frame + ")\n";
  }

  /// Planned contrasts as weights of cells, the last factor varying fastest; those that need other
  /// stimuli are named in a comment.
  std::string contrasts() const {
    const Crossing& crossing = results.effects.crossing;
    std::string list, omitted, scales;
    if (!is_crossed)
      return std::string("planned <- list()\nplanned_scales <- list()\n") + planned_on;
    for (const PlannedContrast& contrast : results.answer_set.factorial.contrasts) {
      const auto matched =
          matched_settings(results.answer_set.factors, contrast.weights, contrast.at);
      std::vector<double> weights(crossing.cells.size(), 0.0);
      bool has_all = true;
      for (const MatchedSetting& setting : matched) {
        for (const auto& [weight, stimuli] : setting.cells) {
          const auto cell = std::ranges::find(crossing.cells, stimuli);
          has_all = has_all && cell != crossing.cells.end();
          if (cell != crossing.cells.end())
            weights[static_cast<std::size_t>(cell - crossing.cells.begin())] +=
                weight / static_cast<double>(matched.size());
        }
      }
      if (!has_all) {
        omitted +=
            "# Not in this model, because it compares other cells: " + comment_text(contrast.name) +
            "\n";
        continue;
      }
      list += fmt::format("{}\n  {} = c({:.15g})", list.empty() ? "" : ",",
                          quoted_in_r(contrast.name), fmt::join(weights, ", "));
      if (!contrast.scales.empty())
        scales += fmt::format("{}\n  {} = {}", scales.empty() ? "" : ",",
                              quoted_in_r(contrast.name), vector_in_r(contrast.scales));
    }
    if (!scales.empty())
      scales = "# The scales of contrasts that are not planned for all.\nplanned_scales <- list(" +
               scales + ")\n";
    else
      scales = "planned_scales <- list()\n";
    return omitted + "planned <- list(" + list + ")\n" + scales + planned_on;
  }

 private:
  static constexpr char planned_on[] =
      "planned_on <- function(scale)\n"
      "  Filter(length, sapply(names(planned), function(name)\n"
      "    if (is.null(planned_scales[[name]]) || scale %in% planned_scales[[name]])\n"
      "      planned[[name]], simplify = FALSE))\n";

  void use_all_stimuli() {
    const auto add = [&](const char* name, auto level_of_stimulus) {
      std::vector<std::string> column, levels;
      for (const ReportedStimulus& stimulus : results.answer_set.stimuli) {
        column.push_back(level_of_stimulus(stimulus));
        if (std::ranges::find(levels, column.back()) == levels.end())
          levels.push_back(column.back());
      }
      if (levels.size() < 2) return;
      factors.emplace_back(name);
      columns_.push_back(column);
      levels_.push_back(levels);
    };
    for (const ReportedStimulus& stimulus : results.answer_set.stimuli)
      stimuli_.push_back(stimulus.id);
    add("made", [](const ReportedStimulus& s) { return s.made; });
    add("emotion", [](const ReportedStimulus& s) { return s.emotion; });
    add("setting", [](const ReportedStimulus& s) { return s.setting; });
  }

  std::vector<std::string> stimuli_;
  std::vector<std::vector<std::string>> columns_;  ///< levels of the stimuli, by factor
  std::vector<std::vector<std::string>> levels_;   ///< all levels, by factor
};

std::string head_of(const DesignInR& design, const std::string& what, const std::string& file,
                    const std::string& packages, const DatasetPaths& paths) {
  const AnswerSet& answer_set = design.results.answer_set;
  std::string libraries;
  std::string quoted = packages;
  for (std::size_t begin = 0; begin < packages.size();) {
    const std::size_t end = std::min(packages.find(' ', begin), packages.size());
    libraries += fmt::format("suppressPackageStartupMessages(library({}))\n",
                             packages.substr(begin, end - begin));
    begin = end + 1;
  }
  std::string text = fmt::format(
      R"script(# {what} of the ratings of "{study}", scale by scale.{simulated}
#
# Run in this folder:  Rscript {file}
# Requires R and the packages {packages}.

{libraries}options(contrasts = c("contr.sum", "contr.poly"), width = 120)

# Texts, also where they look like numbers or TRUE and FALSE.
texts <- c("participant", "session", "block", "kind", "stimulus", "stimulus_sha256", "against",
           "level", "track", "item", "value_raw", "value", "pole_left", "expected", "play_fault",
           "comment", "seed", "design")
answers <- read.csv(file.path("..", "{answers}"), encoding = "UTF-8", na.strings = "",
                    colClasses = setNames(rep("character", length(texts)), texts))

# The answers analysed in the report: ratings outside practice, warm-up and checks, by
# participants who were not excluded.
counted <- subset(answers, ({on_scale}) &
                    is_practice == 0 & is_warmup == 0 & is_check == 0 &
                    excluded == 0 & !is.na(value))
counted$value <- as.numeric(counted$value)

# {stimuli}
{design}counted <- merge(counted, design, by = "stimulus")
)script",
      fmt::arg("what", what), fmt::arg("study", comment_text(answer_set.study)),
      fmt::arg("simulated", answer_set.simulated ? "\n# SIMULATED answers." : ""),
      fmt::arg("file", file), fmt::arg("packages", packages), fmt::arg("libraries", libraries),
      fmt::arg("answers", paths.answers), fmt::arg("on_scale", on_scale_in_r()),
      fmt::arg("stimuli", design.is_crossed ? "The cells of the design that the report analyses."
                                            : "The stimuli with their levels."),
      fmt::arg("design", design.design_frame()));
  if (!design.group.empty())
    text += fmt::format(
        R"script(
# Groups of participants; those for whom several rows have an answer are in none. Answers lose the
# mark by which spreadsheets do not take them for formulas.
people <- read.csv(file.path("..", "{people}"), encoding = "UTF-8", check.names = FALSE,
                   colClasses = "character", na.strings = "")
people <- people[!is.na(people[[{question}]]), ]
people <- people[!people$participant %in% people$participant[duplicated(people$participant)], ]
counted${group} <- sub("^'(?='* *[=+@-])", "", perl = TRUE,
  people[[{question}]][match(counted$participant, people$participant)])
# Those that the report analyses: of at least two participants with answers in all cells.
analysed <- {groups}
counted <- counted[paste(counted$item, counted${group}) %in% analysed, ]
counted${group} <- factor(counted${group})
)script",
        fmt::arg("people", paths.participants), fmt::arg("group", design.group),
        fmt::arg("question", quoted_in_r(design.results.effects.between)),
        fmt::arg("groups", analysed_groups_in_r(design.results)));
  return text +
         "if (nrow(counted) == 0) stop(\"data/ has no ratings that the report analyses\")\n"
         "counted$participant <- factor(counted$participant)\n"
         "counted$stimulus <- factor(counted$stimulus)\n";
}

/// What the mixed models say about their effects.
std::string effects_comment(const DesignInR& design) {
  std::string text = fmt::format(
      "\n# Fixed effects: the factors of the {}.\n"
      "# Random effects: participants, who may favour one end of the scale{}.\n",
      design.is_crossed ? "design with all interactions" : "stimuli, without interactions",
      design.results.answer_set.factorial.random_slopes ? "\n# and differ in the effects of factors"
                                                        : "");
  text +=
      design.has_random_stimuli
          ? "# Also stimuli, which are a sample of possible stimuli.\n"
          : "# Not stimuli: there is one in each cell, and its effect and that of the cell cannot "
            "be\n# distinguished.\n";
  return text;
}

std::string mixed_script(const DesignInR& design, const DatasetPaths& paths) {
  return head_of(design, "Linear mixed models", "lme4.R", "lme4 lmerTest emmeans", paths) +
         effects_comment(design) + design.contrasts() +
         fmt::format(R"script(
for (scale in unique(counted$item)) {{
  d <- droplevels(subset(counted, item == scale))
  cat("\n=====", scale, "=====\n")
  model <- lmer(value ~ {fixed} + {random}, data = d)
  print(summary(model), correlation = FALSE)
  if (isSingular(model))
    cat("\nSINGULAR FIT: some variance of the random effects is estimated as 0, or a correlation",
        "as 1. Simplify the random effects, and report that.\n")
  print(anova(model, type = 3))  # Satterthwaite's degrees of freedom
  if (length(planned_on(scale)) > 0)  # p values not corrected for multiple comparisons
    print(contrast(emmeans(model, {specs}, lmer.df = "satterthwaite"), planned_on(scale), adjust = "none"))
}}
)script",
                     fmt::arg("fixed", design.fixed()), fmt::arg("random", design.random()),
                     fmt::arg("specs", design.specs()));
}

std::string ordinal_script(const DesignInR& design, const DatasetPaths& paths) {
  return head_of(design, "Cumulative link mixed models", "ordinal.R", "ordinal emmeans", paths) +
         "\n# Answers as ordered categories, without assuming equal steps between them.\n" +
         effects_comment(design).substr(1) + design.contrasts() +
         fmt::format(R"script(
for (scale in unique(counted$item)) {{
  d <- droplevels(subset(counted, item == scale))
  d$answer <- factor(d$value, ordered = TRUE)
  cat("\n=====", scale, "=====\n")
  if (nlevels(d$answer) < 3) {{
    cat("Fewer than three different answers: no model.\n")
    next
  }}
  model <- clmm(answer ~ {fixed} + {random}, data = d, link = "logit")
  print(summary(model))
  smallest <- vapply(VarCorr(model), function(v) min(eigen(v)$values), 0)
  if (any(smallest < 1e-6))
    cat("\nSINGULAR FIT: the variance of", names(smallest)[smallest < 1e-6], "is estimated as 0.",
        "Simplify the random effects, and report that.\n")
  if (length(planned_on(scale)) > 0)  # log odds; p values not corrected for multiple comparisons
    tryCatch(
      print(contrast(emmeans(model, {specs}), planned_on(scale), adjust = "none")),
      error = function(e) cat("\nNo contrasts, because the model is not determined by these",
                              "answers:", conditionMessage(e), "\n"))
}}
)script",
                     fmt::arg("fixed", design.fixed()), fmt::arg("random", design.random()),
                     fmt::arg("specs", design.specs()));
}

std::string variance_script(const DesignInR& design, const DatasetPaths& paths) {
  return head_of(design, "Analyses of variance", "afex.R", "afex emmeans", paths) + "\n" +
         design.contrasts() +
         fmt::format(R"script(
# The analysis of variance of the report (results/anova.csv), by another program. Participants who
# miss a cell are left out.
for (scale in unique(counted$item)) {{
  d <- droplevels(subset(counted, item == scale))
  cat("\n=====", scale, "=====\n")
  model <- aov_ez("participant", "value", d, within = {within},{between} fun_aggregate = mean,
                  anova_table = list(es = c("pes", "ges"), correction = "GG"))
  print(model$anova_table)
  if (length(planned_on(scale)) > 0)  # p values not corrected for multiple comparisons
    print(contrast(emmeans(model, {specs}, model = "multivariate"), planned_on(scale), adjust = "none"))
}}
)script",
                     fmt::arg("within", vector_in_r(design.factors)),
                     fmt::arg("between", design.group.empty()
                                             ? ""
                                             : fmt::format(" between = {0}, observed = {0},",
                                                           quoted_in_r(design.group))),
                     fmt::arg("specs", design.specs()));
}

}  // namespace

std::vector<DatasetFile> r_scripts(const Results& results) {
  const DatasetPaths paths = dataset_paths(results.answer_set.study);
  const DesignInR design(results);
  std::vector<DatasetFile> scripts = {{"analysis/lme4.R", mixed_script(design, paths)},
                                      {"analysis/ordinal.R", ordinal_script(design, paths)}};
  if (design.is_crossed) scripts.push_back({"analysis/afex.R", variance_script(design, paths)});
  return scripts;
}

}  // namespace mien::pipeline
