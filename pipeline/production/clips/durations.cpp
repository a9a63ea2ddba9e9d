#include "pipeline/production/clips/durations.h"

#include "motion/error.h"
#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

/// All rows say the same.
double common_duration_in(const fs::path& file) {
  const CsvTable table = read_csv(file);
  const auto column = static_cast<std::size_t>(require_column(table, "duration_s"));
  if (!table.rows.empty()) return number_in(table, table.rows.front()[column]);
  throw Error({file.string()}, "says of no stimulus how long all films are",
              "remove it, and run the study again");
}

void know_durations(const fs::path& folder, FinishedMotions& motions) {
  motions.know_shortest(common_duration_in(folder / durations_form.path));
}

}  // namespace mien::pipeline
