#include "pipeline/results/report/results_report.h"

#include "pipeline/documents/files.h"
#include "pipeline/results/figures/result_figures.h"
#include "pipeline/results/report/dataset.h"
#include "pipeline/results/report/r_scripts.h"
#include "pipeline/results/result_tables.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// In a folder that reports may be written to, and written over.
constexpr char results_mark[] = ".mien-results";

void write_below(const fs::path& folder, const std::string& path, const std::string& bytes) {
  make_folder((folder / path).parent_path());
  write_file(folder / path, bytes);
}

/// Which of the figures of the thesis is where.
std::string figure_list(const std::vector<ResultFigure>& figures, const Results& results) {
  CsvWriter writer({"thesis_figure", "file", "title", "simulated"});
  const std::string simulated = results.gathered.simulated ? "1" : "0";
  for (const ResultFigure& figure : figures)
    writer.row({figure.thesis, "figures/" + figure.name, figure.plot.title, simulated});
  const auto has = [&](ComparisonFamily family, const std::string& made) {
    for (const Comparison& c : results.comparisons)
      if (c.family == family && (made.empty() || results.gathered.stimuli[c.stimulus].made == made))
        return true;
    return false;
  };
  for (const StimulusGroup& group : stimulus_groups(results.gathered)) {
    const std::string made = group.name == "all" ? "" : group.name;
    if (!group.table.empty() && has(ComparisonFamily::best_seen, made))
      writer.row({group.table, "results/comparisons.csv",
                  "Table: what is seen best in the " + group.words, simulated});
  }
  if (has(ComparisonFamily::modified_acted, ""))
    writer.row(
        {"37", "results/comparisons.csv", "Table: modified against acted motions", simulated});
  if (has(ComparisonFamily::modified_neutral, ""))
    writer.row(
        {"38", "results/comparisons.csv", "Table: modified against neutral motions", simulated});
  return writer.text();
}

}  // namespace

void clear_results_folder(const fs::path& folder) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw Error({folder.string()}, "is no folder", "name one for the report with -o");
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / results_mark))
    throw Error({folder.string()}, "holds something else than a report of mien study report",
                "name a new folder with -o");
  make_folder(folder);
  write_file(folder / results_mark, "");
  for (const char* old : {"data", "results", "figures", "analysis", "report.html", "README.md",
                          "dataset_description.json", "codebook.csv", "figures.csv"})
    fs::remove_all(folder / old);
}

void write_results(const Results& results, const std::vector<AnswerRow>& rows,
                   const FrozenVerdict& frozen, const fs::path& folder) {
  const std::vector<ResultTable> tables = result_tables(results);
  const std::vector<ResultFigure> figures = result_figures(results);
  for (const ResultTable& table : tables)
    write_below(folder, std::string(table.form->path), table.csv);
  for (const DatasetFile& file : dataset_files(results, rows, tables))
    write_below(folder, file.path, file.bytes);
  make_folder(folder / "figures");
  for (const ResultFigure& figure : figures)
    write_plot(figure.plot, folder / "figures", figure.name);
  write_below(folder, "figures.csv", figure_list(figures, results));
  if (!results.gathered.ratings.empty()) {
    const DatasetPaths paths = dataset_paths(results.gathered.study);
    const RScripts scripts = r_scripts(results.gathered, paths.answers, paths.stimuli);
    write_below(folder, "analysis/lme4.R", scripts.mixed);
    write_below(folder, "analysis/ordinal.R", scripts.ordinal);
  }
  write_below(folder, "report.html", results_page(results, figures, tables, frozen));
}

}  // namespace mien::pipeline
