#include "motion/text/result_files.h"

#include <deque>
#include <system_error>
#include <vector>

#include "motion/text/result_file.h"

namespace mien::motion {

namespace {

namespace fs = std::filesystem;

void write_draft(const ResultFile& result, std::string_view bytes) {
  try {
    write_in_place(result.draft(), bytes);
  } catch (const WriteFailure& failure) {
    throw WriteFailure(result.with_target_name(failure.what()), failure.code());
  }
}

}  // namespace

void write_results(std::span<const ResultBytes> files) {
  std::deque<ResultFile> results;
  std::vector<fs::path> were_missing;  // of those that have appeared
  for (const ResultBytes& file : files) write_draft(results.emplace_back(file.target), file.bytes);
  try {
    for (auto result = results.rbegin(); result != results.rend(); ++result) {
      std::error_code unknown;
      const bool is_new = !fs::exists(result->target(), unknown);
      result->publish();
      if (is_new) were_missing.push_back(result->target());
    }
  } catch (...) {
    std::error_code ignored;
    for (const fs::path& file : were_missing) fs::remove(file, ignored);
    throw;
  }
}

}  // namespace mien::motion
