#include "pipeline/study/questionnaire/analysis_plan.h"

#include <fmt/format.h>

#include "pipeline/manifest/adaptive_text.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/quality_rules.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reported_analyses.h"

namespace mien::pipeline {

namespace {

constexpr char no_analysis_plan[] =
    "No analysis plan: the manifest has no questionnaire.analysis.plan.\n";

/// How the part of analysis-plan.txt begins that follows the manifest's plan.
constexpr char tests_begin[] = "All tests are two-sided with α = ";

/// The level of significance, the correction and the exclusion of participants.
std::string tests_plan(const Questionnaire& asked) {
  const AnalysisPlan& analysis = asked.analysis;
  std::string text = fmt::format("{}{:g}; ", tests_begin, analysis.alpha);
  text += analysis.correction == TestCorrection::none
              ? "p values are not corrected for multiple comparisons.\n"
              : fmt::format("p values are corrected within each family of comparisons ({}).\n",
                            word_of(correction_words, analysis.correction));
  if (asked.trials->is_continuous)
    text += fmt::format(
        "Traces are {}; the means of trials leave out the first {:g} s of the film.\n",
        analysis.lag > 0.0 ? fmt::format("moved back by {:g} s", analysis.lag) : "not moved back",
        asked.continuous.lead);
  if (asked.attention_every > 0)
    text += fmt::format(
        "Participants who fail more than {} attention check{} are left out of the analysis with "
        "all of their answers.\n",
        analysis.max_failed_checks, analysis.max_failed_checks == 1 ? "" : "s");
  return text;
}

/// What the report computes in any case.
std::string reported_text(const Manifest& manifest) {
  std::string text;
  for (const std::string& sentence : reported_analyses(manifest, ReportTense::present))
    text += (text.empty() ? "\nmien study report computes in any case:\n" : "") +
            ("- " + sentence + ".\n");
  return text;
}

}  // namespace

std::string analysis_plan_text(const Manifest& manifest) {
  const AnalysisPlan& analysis = questionnaire_of(manifest).analysis;
  std::string plan = analysis.plan.text.empty() ? no_analysis_plan : analysis.plan.text;
  for (const std::string& part :
       {tests_plan(questionnaire_of(manifest)), adaptive_plan_text(manifest),
        factorial_plan_text(analysis.factorial, analysed_answers(manifest)),
        quality_plan(questionnaire_of(manifest))})
    if (!part.empty()) plan += (plan.ends_with('\n') ? "\n" : "\n\n") + part;
  return plan + reported_text(manifest);
}

std::string stated_plan_in(const std::string& analysis_plan) {
  std::string plan = analysis_plan.substr(0, analysis_plan.rfind(tests_begin));
  while (plan.ends_with('\n')) plan.pop_back();
  return plan;
}

}  // namespace mien::pipeline
