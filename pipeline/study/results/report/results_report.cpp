#include "pipeline/study/results/report/results_report.h"

#include <algorithm>

#include "motion/text/safe_name.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/study/results/report/dataset.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Name of the file that marks a folder as a report, which may be overwritten.
constexpr char results_marker[] = ".mien-results";

void write_below(const fs::path& folder, const std::string& path, const std::string& bytes) {
  make_folder((folder / path).parent_path());
  write_file(folder / path, bytes);
}

struct ListedFigure {
  std::string file;
  std::string title;
  std::string thesis;
  std::string former_name;
  bool simulated;
};

constexpr auto figures_columns = table_of<ListedFigure>(
    "figures.csv", "figure, or table that corresponds to a figure of the emotion thesis",
    {{"file", "", "file; for figures, its name without extension", [](auto& r) { return r.file; }},
     {"title", "", "title of the figure", [](auto& r) { return r.title; }},
     {"thesis_figure", "", "number of the corresponding figure of the emotion thesis",
      [](auto& r) { return r.thesis; }},
     {"earlier_name", "", "former name of its file", [](auto& r) { return r.former_name; }},
     {"simulated", "0/1", "1: made from simulated answers", [](auto& r) { return r.simulated; }}});

/// The list of figures with captions and the corresponding figures of the thesis.
std::string figure_list(const std::vector<ResultFigure>& figures, const Results& results) {
  const bool simulated = results.answer_set.simulated;
  std::vector<ListedFigure> rows;
  for (const ResultFigure& figure : figures)
    rows.push_back({"figures/" + figure.name, figure.plot.title, figure.thesis, figure.former_name,
                    simulated});
  const auto table = [&](const std::string& file, const std::string& title,
                         const std::string& thesis) {
    rows.push_back({"results/" + file, "Table: " + title, thesis, "", simulated});
  };
  const auto has = [&](ComparisonFamily family) {
    return std::ranges::any_of(results.comparisons,
                               [=](const Comparison& c) { return c.family == family; });
  };
  if (has(ComparisonFamily::best_seen))
    table("comparisons.csv", "highest-rated video for each end of each scale (best-seen)", "31");
  if (has(ComparisonFamily::modified_acted))
    table("comparisons.csv", "modified vs. acted motions (modified-acted)", "37");
  const bool has_actors = std::ranges::any_of(results.comparisons, [](const Comparison& c) {
    return c.family == ComparisonFamily::between_levels && c.factor == "actor";
  });
  if (has(ComparisonFamily::between_levels))
    table("comparisons.csv", "levels of a factor compared (between-levels)",
          has_actors ? "38" : "");
  if (!results.groups.empty())
    table("groups.csv", "groups of participants compared",
          std::ranges::any_of(results.groups,
                              [](const GroupComparison& c) { return c.question == "gender"; })
              ? "41"
              : "");
  return figures_columns.of(rows).csv;
}

}  // namespace

void clear_results_folder(const fs::path& folder) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw Error({folder.string()}, "is not a folder", "name a folder for the report with -o");
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / results_marker))
    throw Error({folder.string()}, "exists, but was not written by mien study report",
                "name a new folder with -o");
  make_folder(folder);
  write_file(motion::inside(folder, results_marker, {folder.string()}), "");
  for (const char* old : {"data", "results", "figures", "analysis", "report.html", "README.md",
                          "dataset_description.json", "codebook.csv", "figures.csv"})
    fs::remove_all(folder / old);
}

void write_results(const Results& results, const std::vector<AnswerRow>& rows,
                   const FrozenVerdict& frozen, const fs::path& folder) {
  const std::vector<WrittenTable> tables = result_tables(results);
  const std::vector<ResultFigure> figures = result_figures(results);
  for (const WrittenTable& table : tables)
    write_below(folder, std::string(table.form.path), table.csv);
  for (const DatasetFile& file : dataset_files(results, rows, tables))
    write_below(folder, file.path, file.bytes);
  make_folder(folder / "figures");
  for (const ResultFigure& figure : figures)
    write_plot(figure.plot, folder / "figures", figure.name);
  write_below(folder, "figures.csv", figure_list(figures, results));
  if (!results.answer_set.ratings.empty())
    for (const DatasetFile& script : r_scripts(results))
      write_below(folder, script.path, script.bytes);
  write_below(folder, "report.html", results_page(results, figures, tables, frozen));
}

}  // namespace mien::pipeline
