#include "pipeline/commands/study/frozen_archive.h"

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/archive/scratch_folder.h"
#include "pipeline/production/methods/methods.h"
#include "pipeline/study/questionnaire/frozen_design.h"
#include "pipeline/study/questionnaire/simulated_people.h"
#include "pipeline/study/results/report/results_report.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Adds the report of mien study report for answers without any effect.
void add_dummy_report(ZipFiles& files, const Manifest& manifest,
                      const std::vector<SessionPlan>& plans) {
  const ScratchFolder folder;
  const std::vector<AnswerRow> rows = dummy_answers(manifest, plans);
  ParticipantTable people;
  if (asks_about_participants(manifest))
    people = {parse_csv(simulated_people_csv(manifest, plans), "participants.csv")};
  ReportChoices choices;
  choices.finished = people.finished();
  const Results results = results_of(collect_answers(manifest, rows, choices), rows, people);
  write_results(results, rows, {}, folder.path());
  const fs::path about = folder.path() / "README.md";
  write_file(about, read_file(about) + "\n" + dummy_assumptions(manifest));
  add_folder(files, folder.path(), "dummy-report");
}

/// Whether the manifest has completion codes or redirects, with which people who did not take part
/// could be paid.
bool has_completion_codes(const Manifest& manifest) {
  const Recruitment& recruitment = questionnaire_of(manifest).recruitment;
  return recruitment.prolific != SessionEndTexts{} || recruitment.redirect != SessionEndTexts{};
}

}  // namespace

FrozenArchive frozen_archive(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                             const ZipFiles& power, const fs::path& made, const fs::path& file) {
  ZipFiles files = frozen_design(manifest, plans, made);
  files.insert(power.begin(), power.end());
  const Methods procedure = procedure_of(manifest);
  files["procedure.md"] =
      "*The sections of the methods as they will be stated after the study, if it is run as "
      "planned; hence the past tense.*\n\n" +
      procedure.markdown;
  files["references.bib"] = procedure.bibtex;
  add_dummy_answers(files, manifest, plans);
  add_dummy_report(files, manifest, plans);
  FrozenArchive archive{.file = file, .bytes = zip_of(files), .files = files.size()};
  refuse_other_content(file, archive.bytes);
  return archive;
}

void remark_on_archive(const Manifest& manifest, bool has_power, const Console& console) {
  if (questionnaire_of(manifest).analysis.plan.text.empty())
    console.err << "warning: the manifest has no analysis plan, which a preregistration requires; "
                   "write it in questionnaire.analysis.plan\n";
  if (manifest.output.quality == Quality::draft)
    console.err << "note: the archive states that the videos are of draft quality; set "
                   "output.quality of the manifest to the quality that participants will see\n";
  if (has_completion_codes(manifest))
    console.err << "note: the archive contains the manifest with its completion codes and "
                   "redirects; do not publish it before data collection is over\n";
  if (!has_power && questionnaire_of(manifest).adaptive.empty())
    console.err << "note: the archive states no power analysis; --power, with --planned-tests for "
                   "the tests of the analysis plan, adds one\n";
}

void write_archive(const FrozenArchive& archive) {
  replace_file(archive.file, archive.file.string() + ".part", archive.bytes);
}

}  // namespace mien::pipeline
