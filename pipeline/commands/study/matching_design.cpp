#include "pipeline/commands/study/matching_design.h"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/session_duration.h"

namespace mien::pipeline {

namespace {

void print_matching(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                    std::ostream& out) {
  const Matching& matching = *manifest.matching;
  const std::size_t targets = matching_targets(manifest).size();
  const auto practised = std::ranges::count_if(plans[0].trials, &Trial::practice);
  out << fmt::format(
      "{}: {} participants, {} trials each: {} practice trials, then {} targets with each of {} "
      "interfaces\n",
      manifest.study, plans.size(), plans[0].trials.size(), practised, targets,
      matching.interfaces.size());
  if (matching.order == MatchingOrder::guesses_first)
    out << "For each target, guesses with all interfaces come first, then the matches.\n";
  const std::size_t orders = williams_rows(matching.interfaces.size());
  if (plans.size() % orders == 0)
    out << "Every row of the interfaces' Latin square is given to equally many participants.\n";
  else
    out << fmt::format(
        "The orders of interfaces are balanced if the number of participants is a multiple of "
        "{}.\n",
        orders);
  const std::size_t whole = orders * williams_rows(targets);
  if (plans.size() % whole != 0)
    out << fmt::format(
        "Targets, positions and interfaces are balanced if it is a multiple of {}.\n", whole);
  out << fmt::format(
      "Expected duration of a session: {}, assuming half of the time limit per match.\n",
      duration_text(plans));
}

}  // namespace

int design_matching(const Manifest& manifest, const MatchingDesign& design,
                    const Console& console) {
  Motions motions(manifest);
  const MatchingStudy study = matching_study(manifest, motions, design.participants);
  warn_of_matched_at_start(manifest, study, console);
  const std::vector<SessionPlan>& plans = study.plans;
  const std::string csv = plans_csv(plans);
  if (design.plans.empty()) {
    console.out << csv;
    print_matching(manifest, plans, console.err);
    return exit_done;
  }
  std::vector<std::filesystem::path> read;
  for (const InputCopy& input : input_copies(manifest)) read.push_back(input.source);
  refuse_data_loss({{design.plans, csv}}, read);
  print_matching(manifest, plans, console.out);
  write_file(design.plans, csv);
  console.out << design.plans.string() << '\n';
  return exit_done;
}

void warn_of_matched_at_start(const Manifest& manifest, const MatchingStudy& study,
                              const Console& console) {
  const std::string warning = starting_match_warning(manifest, study);
  if (!warning.empty()) console.err << "warning: " << warning << '\n';
}

}  // namespace mien::pipeline
