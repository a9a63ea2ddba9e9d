#include "pipeline/commands/study/frozen_archive.h"

#include <system_error>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/study/questionnaire/frozen_design.h"
#include "pipeline/study/results/report/results_report.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& file, const char* ending) { return file.string() + ending; }

/// A folder beside a file, for as long as it is needed.
class FolderBeside {
 public:
  explicit FolderBeside(const fs::path& file) : path_(beside(file, ".part.d")) {
    fs::remove_all(path_);
    make_folder(path_);
  }
  ~FolderBeside() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  FolderBeside(const FolderBeside&) = delete;
  FolderBeside& operator=(const FolderBeside&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// What mien study report would write of answers in which all stimuli are alike.
void add_dummy_report(ZipFiles& files, const Manifest& manifest,
                      const std::vector<SessionPlan>& plans, const fs::path& file) {
  const FolderBeside folder(file);
  const std::vector<AnswerRow> rows = dummy_answers(manifest, plans);
  const Results results = results_of(gather(manifest, rows), rows, {});
  write_results(results, rows, {}, folder.path());
  add_folder(files, folder.path(), "dummy-report");
}

}  // namespace

FrozenArchive frozen_archive(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                             const fs::path& made, const fs::path& file) {
  ZipFiles files = frozen_design(manifest, plans, made);
  add_dummy_answers(files, manifest, plans);
  add_dummy_report(files, manifest, plans, file);
  FrozenArchive archive{.file = file, .bytes = zip_of(files), .files = files.size()};
  if (fs::exists(fs::symlink_status(file)) && read_file(file) != archive.bytes)
    throw Error({file.string()}, "is there already, and holds something else",
                "name another file, or remove it");
  return archive;
}

void write_archive(const FrozenArchive& archive) {
  replace_file(archive.file, beside(archive.file, ".part"), archive.bytes);
}

}  // namespace mien::pipeline
