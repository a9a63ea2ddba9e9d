#include "pipeline/manifest/ratings/answers/trace_table.h"

#include <algorithm>
#include <cmath>

#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

namespace {

struct TraceSample {
  const AnswerRow& answer;
  double time_s;
  double value;
};

constexpr auto trace_columns = table_of<TraceSample>(
    "traces.csv", "sample of a trace, ten in each second of the film",
    {{"participant", "", "participant id: position in the design, not a name",
      [](auto& r) { return r.answer.participant; }},
     {"session", "", "random id of the browser session", [](auto& r) { return r.answer.session; }},
     {"trial", "", "trial number in the participant's order, from 1",
      [](auto& r) { return r.answer.trial; }},
     {"stimulus", "", "stimulus that was rated while it played",
      [](auto& r) { return r.answer.stimulus; }},
     {"scale", "", "scale id", [](auto& r) { return r.answer.item; }},
     {"time_s", "s", "time of the film, not moved by a lag; the last sample is at its end",
      [](auto& r) { return r.time_s; }},
     {"value", "0–100", "position of the marker, increasing towards the high end",
      [](auto& r) { return r.value; }},
     {"simulated", "0/1", "1: simulated answer", [](auto& r) { return r.answer.simulated; }}});

bool is_of_continuous(const AnswerRow& row) { return row.kind == continuous_form.name; }

}  // namespace

const TableForm traces_form = trace_columns.form();

std::optional<std::vector<double>> trace_of(const AnswerRow& row) {
  if (!is_of_continuous(row)) return std::nullopt;
  auto trace = read_trace(row.value_raw);
  if (!trace || row.pole_left != "high") return trace;
  for (double& sample : *trace) sample = std::round(10.0 * (100.0 - sample)) / 10.0;
  return trace;
}

bool has_traces(const std::vector<AnswerRow>& rows) {
  return std::ranges::any_of(rows, is_of_continuous);
}

std::string traces_csv(const std::vector<AnswerRow>& rows,
                       const std::map<std::string, double>& film_seconds) {
  CsvWriter writer(header_of(traces_form));
  for (const AnswerRow& row : rows) {
    const auto trace = trace_of(row);
    const auto film = film_seconds.find(row.stimulus);
    const double seconds = film == film_seconds.end() ? 0.0 : film->second;
    for (std::size_t k = 0; trace && k < trace->size(); ++k)
      writer.row(trace_columns.fields_of({row, sample_time(k, seconds), (*trace)[k]}));
  }
  return writer.text();
}

}  // namespace mien::pipeline
