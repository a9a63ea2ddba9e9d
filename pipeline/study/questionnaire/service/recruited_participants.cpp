#include "pipeline/study/questionnaire/service/recruited_participants.h"

#include <algorithm>

#include "pipeline/base/documents/sha256.h"
#include "pipeline/study/questionnaire/service/record_check.h"

namespace mien::pipeline {

std::string pseudonym_of(const std::string& salt, const std::string& name,
                         const std::string& value) {
  constexpr std::size_t digits = 32;
  return sha256_of(salt + "\n" + name + "\n" + value).substr(0, digits);
}

void pseudonymise(PageRecord& record, nlohmann::json& text, const std::string& salt) {
  for (auto& [name, value] : record.url_parameters) {
    value = pseudonym_of(salt, name, value);
    text["url_parameters"][name] = value;
  }
}

SessionEnd completed_end(const QuestionnaireFacts& facts, const SessionPlan& plan,
                         const std::vector<StoredRecord>& records) {
  int failed = 0;
  for (const StoredRecord& stored : records) {
    const Trial* trial = trial_of(plan, stored.name);
    if (trial == nullptr || !trial->is_attention_check()) continue;
    const PageRecord record = read_record(nlohmann::json::parse(stored.content));
    for (const AnswerRow& row : rows_of(facts, plan, *trial, record))
      failed += row.passed.value_or(true) || row.is_practice ? 0 : 1;
  }
  return failed > facts.recruitment.most_failed_checks ? SessionEnd::failed_attention
                                                       : SessionEnd::completed;
}

nlohmann::ordered_json destination_json(const nlohmann::ordered_json& experiment, SessionEnd end) {
  const auto recruitment = experiment.find("recruitment");
  if (recruitment == experiment.end()) return nullptr;
  const nlohmann::ordered_json& ends = recruitment->at("ends");
  auto found = ends.find(word_of(session_end_words, end));
  if (found == ends.end() && end == SessionEnd::failed_attention)
    found = ends.find(word_of(session_end_words, SessionEnd::completed));
  return found == ends.end() ? nlohmann::ordered_json() : *found;
}

nlohmann::ordered_json public_recruitment(const nlohmann::ordered_json& recruitment) {
  nlohmann::ordered_json seen = recruitment;
  for (const SessionEnd end :
       {SessionEnd::completed, SessionEnd::failed_attention, SessionEnd::withdrawn})
    seen["ends"].erase(std::string(word_of(session_end_words, end)));
  return seen;
}

}  // namespace mien::pipeline
