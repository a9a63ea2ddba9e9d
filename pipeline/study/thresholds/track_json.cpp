#include "pipeline/study/thresholds/track_json.h"

namespace mien::pipeline {

using nlohmann::ordered_json;

ordered_json procedure_json(const TrackProcedure& procedure) {
  ordered_json text = {{"method", word_of(adaptive_method_words, procedure.method)},
                       {"levels", procedure.levels},
                       {"ease", procedure.ease}};
  if (procedure.method == AdaptiveMethod::quest) {
    const QuestGrid& grid = procedure.quest;
    text["quest"] = {{"location", grid.location},
                     {"width", grid.width},
                     {"guess", grid.guess},
                     {"lapse", grid.lapse}};
    if (procedure.end)
      text["end"] = {{"deviation", procedure.end->deviation},
                     {"proportion", procedure.end->proportion},
                     {"most_trials", procedure.end->most_trials}};
    return text;
  }
  const StaircaseSettings& staircase = procedure.staircase;
  text["staircase"] = {{"start", staircase.start},
                       {"positive_to_fall", staircase.positive_to_fall},
                       {"negative_to_rise", staircase.negative_to_rise},
                       {"step_down", staircase.step_down},
                       {"step_up", staircase.step_up},
                       {"most_reversals", staircase.most_reversals},
                       {"most_trials", staircase.most_trials}};
  return text;
}

TrackProcedure procedure_of(const ordered_json& text) {
  TrackProcedure procedure{.levels = text.at("levels"), .ease = text.at("ease")};
  if (text.at("method") == word_of(adaptive_method_words, AdaptiveMethod::quest)) {
    const ordered_json& grid = text.at("quest");
    procedure.quest = {grid.at("location"), grid.at("width"), grid.at("guess"), grid.at("lapse")};
    if (text.contains("end")) {
      const ordered_json& end = text.at("end");
      procedure.end = QuestEnd{end.at("deviation"), end.at("proportion"), end.at("most_trials")};
    }
    return procedure;
  }
  const ordered_json& given = text.at("staircase");
  procedure.method = AdaptiveMethod::staircase;
  procedure.staircase = {.start = given.at("start"),
                         .positive_to_fall = given.at("positive_to_fall"),
                         .negative_to_rise = given.at("negative_to_rise"),
                         .step_down = given.at("step_down"),
                         .step_up = given.at("step_up"),
                         .most_reversals = given.at("most_reversals"),
                         .most_trials = given.at("most_trials")};
  for (std::size_t place = 0; place < procedure.levels.size(); ++place)
    procedure.staircase.grid.push_back(static_cast<double>(place));
  return procedure;
}

}  // namespace mien::pipeline
