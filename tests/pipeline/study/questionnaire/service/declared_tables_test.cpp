#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/manifest/ratings/answers/trace_table.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/service/chain_rows.h"
#include "pipeline/study/questionnaire/service/matching_rows.h"

namespace mien::pipeline {
namespace {

std::string source_file(const char* path) {
  return read_file(std::filesystem::path(MIEN_SOURCE_DIR) / path);
}

/// Columns of each, which the page finds itself, are left out.
std::string in_typescript(const char* name, const TableForm& form) {
  std::string text = fmt::format("\nexport const {} = [", name);
  const std::vector<std::string> columns = header_of(form);
  for (std::size_t i = 0; i < columns.size(); ++i)
    text += fmt::format("{}\"{}\",", i % 6 == 0 ? "\n  " : " ", columns[i]);
  return text + "\n] as const;\n";
}

TEST(DeclaredTables, HaveTheColumnsOfThePages) {
  const std::string page = source_file("pipeline/study/page/src/questionnaire/columns.ts");
  EXPECT_EQ(page.substr(page.find("\nexport")),
            in_typescript("answerColumns", answer_form) +
                in_typescript("participantColumns", participant_form) +
                in_typescript("trialColumns", matching_trials_form) +
                in_typescript("changeColumns", matching_changes_form) +
                in_typescript("stepColumns", chain_steps_form));
}

TEST(DeclaredTables, ArePagesOfTheManual) {
  std::string sections;
  for (const TableForm& form :
       {answer_form, traces_form, participant_form, plans_form, balance_form, matching_trials_form,
        matching_changes_form, chain_steps_form})
    sections += (sections.empty() ? "" : "\n") + markdown_of(form);
  const std::string page = source_file("pipeline/study/questionnaire/TABLES.md");
  EXPECT_EQ(page.substr(page.find("## ")), sections);
}

}  // namespace
}  // namespace mien::pipeline
