#include "pipeline/commands/study/new_tables.h"

#include <algorithm>
#include <system_error>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Whether two paths name the same file, also through links and if it does not exist yet.
bool are_same_file(const fs::path& one, const fs::path& other) {
  std::error_code unknown;
  if (one.empty() || other.empty()) return false;
  if (fs::equivalent(one, other, unknown)) return true;
  return fs::weakly_canonical(one, unknown) == fs::weakly_canonical(other, unknown);
}

std::string header_of(const std::string& csv) { return csv.substr(0, csv.find('\n') + 1); }

/// Whether a table of answers has rows of participants, not only simulated ones.
bool has_participant_answers(const CsvTable& table) {
  const int simulated = find_column(table, "simulated");
  if (simulated < 0) return false;
  return std::ranges::any_of(table.rows, [&](const auto& row) {
    return row[static_cast<std::size_t>(simulated)].text != "1";
  });
}

void refuse_losing(const NewTable& table) {
  std::error_code unknown;
  if (!fs::is_regular_file(table.file, unknown) || fs::file_size(table.file, unknown) == 0) return;
  const std::string kept = read_file(table.file);
  if (!kept.starts_with(header_of(table.csv)))
    throw Error({table.file.string()}, "exists already and is not an earlier table of this kind",
                "name another file");
  if (has_participant_answers(parse_csv(kept, table.file.string())))
    throw Error({table.file.string()}, "holds answers of real participants", "name another file");
}

}  // namespace

void refuse_data_loss(const std::vector<NewTable>& tables, const std::vector<fs::path>& read,
                      const fs::path& archive) {
  for (auto table = tables.begin(); table != tables.end(); ++table) {
    if (table->file.empty()) continue;
    const auto is_it = [&](const fs::path& other) { return are_same_file(table->file, other); };
    if (std::ranges::any_of(read, is_it))
      throw Error({table->file.string()}, "is an input of this command", "name another file");
    if (is_it(archive) ||
        std::any_of(tables.begin(), table, [&](const NewTable& t) { return is_it(t.file); }))
      throw Error({table->file.string()}, "would be written twice", "name two files");
    refuse_losing(*table);
  }
}

void refuse_other_content(const fs::path& file, const std::string& bytes) {
  if (fs::exists(fs::symlink_status(file)) && read_file(file) != bytes)
    throw Error({file.string()}, "exists already, but holds something else",
                "name another file, or remove it");
}

}  // namespace mien::pipeline
