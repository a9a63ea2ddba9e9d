#include "end_to_end/questionnaire_page.h"

#include <fstream>
#include <utility>

namespace mien::test {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path page_tests() {
  return fs::path(MIEN_PROGRAM).parent_path() / "pages/work/tests/questionnaire";
}

std::vector<std::map<std::string, std::string>> rows_in(const std::string& csv) {
  std::vector<std::vector<std::string>> lines(1, std::vector<std::string>(1));
  bool is_quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& field = lines.back().back();
    if (csv[i] == '"') {
      if (is_quoted && i + 1 < csv.size() && csv[i + 1] == '"')
        field += csv[++i];
      else
        is_quoted = !is_quoted;
    } else if (csv[i] == ',' && !is_quoted) {
      lines.back().emplace_back();
    } else if (csv[i] == '\n' && !is_quoted) {
      lines.emplace_back(1);
    } else {
      field += csv[i];
    }
  }
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < lines[0].size(); ++k) row[lines[0][k]] = lines[i].at(k);
  }
  return rows;
}

std::vector<std::map<std::string, std::string>> rows_of_trial(const json& taken, int trial) {
  auto rows = rows_in(taken.at("answers").get<std::string>());
  std::erase_if(rows, [&](const auto& row) { return row.at("trial") != std::to_string(trial); });
  return rows;
}

std::string wav_of_tone(double seconds) {
  constexpr int rate = 16'000;
  const int count = static_cast<int>(seconds * rate);
  std::string bytes = "RIFF";
  const auto put = [&](std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  };
  put(static_cast<std::uint32_t>(36 + 2 * count), 4);
  bytes += "WAVEfmt ";
  for (const auto& [value, size] :
       {std::pair(16, 4), {1, 2}, {1, 2}, {rate, 4}, {2 * rate, 4}, {2, 2}, {16, 2}})
    put(static_cast<std::uint32_t>(value), size);
  bytes += "data";
  put(static_cast<std::uint32_t>(2 * count), 4);
  for (int i = 0; i < count; ++i)
    put(static_cast<std::uint32_t>(static_cast<int>(8000.0 * std::sin(0.2 * i))), 2);
  return bytes;
}

void export_study(const fs::path& folder) {
  const fs::path manifest = folder / "gaits.yaml";
  std::ofstream(manifest) << study_text;
  must_run(mien_with({"study", "export", manifest.string(), "--out", (folder / "out").string(),
                      "-o", (folder / "questionnaire").string()}));
}

}  // namespace mien::test
