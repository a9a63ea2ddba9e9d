#include "pipeline/farm/slurm/slurm_output.h"

#include <algorithm>
#include <array>

#include "motion/text/as_number.h"
#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::optional<QueueRow> row_of(std::string_view line) {
  constexpr std::size_t before_comment = 7;
  std::array<std::string, before_comment> fields;
  for (std::string& field : fields) {
    const std::size_t bar = line.find('|');
    if (bar == std::string_view::npos) return std::nullopt;
    field = line.substr(0, bar);
    line.remove_prefix(bar + 1);
  }
  if (!motion::as_number<int>(fields[0]) || !motion::as_number<int>(fields[1])) return std::nullopt;
  QueueRow row{fields[0], fields[1],        motion::as_number<int>(fields[2]),
               fields[3], fields[4],        fields[5],
               fields[6], std::string(line)};
  if (row.node == "(null)") row.node.clear();
  return row;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Whether "70-75,80" has the code.
bool has_code(std::string_view list, int code) {
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view part = trimmed(list.substr(0, comma));
    const std::size_t dash = part.find('-');
    const auto first = motion::as_number<int>(part.substr(0, dash));
    const auto last =
        dash == std::string_view::npos ? first : motion::as_number<int>(part.substr(dash + 1));
    if (first && last && *first <= code && code <= *last) return true;
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return false;
}

}  // namespace

std::vector<QueueRow> queue_rows(std::string_view text) {
  std::vector<QueueRow> rows;
  for (const std::string_view line : lines_of(text)) {
    if (auto row = row_of(line)) rows.push_back(std::move(*row));
  }
  return rows;
}

bool is_live(const QueueRow& row) {
  constexpr std::array<std::string_view, 13> live = {
      "PENDING",      "RUNNING",     "CONFIGURING", "COMPLETING", "SUSPENDED",
      "STOPPED",      "REQUEUED",    "SIGNALING",   "RESIZING",   "STAGE_OUT",
      "REQUEUE_HOLD", "REQUEUE_FED", "SPECIAL_EXIT"};
  return std::find(live.begin(), live.end(), row.state) != live.end();
}

bool exceeds_partition(const QueueRow& row) {
  constexpr std::array<std::string_view, 4> reasons = {"PartitionConfig", "PartitionNodeLimit",
                                                       "PartitionTimeLimit", "BadConstraints"};
  return row.state == "PENDING" &&
         std::find(reasons.begin(), reasons.end(), row.reason) != reasons.end();
}

bool is_stuck(const QueueRow& row) {
  if (row.state == "SPECIAL_EXIT" || row.state == "REQUEUE_HOLD") return true;
  return row.state == "PENDING" &&
         (exceeds_partition(row) || row.reason == "DependencyNeverSatisfied" ||
          row.reason.starts_with("JobHeld") ||
          row.reason.starts_with("launch_failed_requeued_held") ||
          row.reason.starts_with("launch failed requeued held"));
}

bool will_proceed(const QueueRow& row) {
  return is_live(row) && !is_stuck(row) && row.state != "COMPLETING";
}

double seconds_run(const QueueRow& row) {
  // "1-02:03:04", "2:03:04", "3:04"
  std::string_view text = row.elapsed;
  double days = 0.0;
  if (const std::size_t dash = text.find('-'); dash != std::string_view::npos) {
    days = motion::as_number<int>(text.substr(0, dash)).value_or(0);
    text.remove_prefix(dash + 1);
  }
  double seconds = 0.0;
  do {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto part = motion::as_number<int>(text.substr(0, colon));
    if (!part) return 0.0;
    seconds = 60.0 * seconds + *part;
    text.remove_prefix(std::min(colon + 1, text.size()));
  } while (!text.empty());
  return 86400.0 * days + seconds;
}

NodeStates node_states(std::string_view text) {
  NodeStates states;
  for (const std::string_view line : lines_of(text)) {
    const std::size_t bar = line.rfind('|');
    if (bar == std::string_view::npos) continue;
    states[std::string(trimmed(line.substr(0, bar)))] = trimmed(line.substr(bar + 1));
  }
  return states;
}

std::vector<NodeShape> node_shapes(std::string_view text) {
  std::vector<NodeShape> nodes;
  for (const std::string_view line : lines_of(text)) {
    const std::size_t bar = line.rfind('|');
    if (bar == std::string_view::npos) continue;
    const auto processors = motion::as_number<int>(trimmed(line.substr(bar + 1)));
    std::string_view partition = line.substr(0, bar);
    const bool is_default = partition.ends_with('*');
    if (is_default) partition.remove_suffix(1);
    if (processors) nodes.push_back({std::string(partition), is_default, *processors});
  }
  return nodes;
}

std::optional<int> most_processors(const std::vector<NodeShape>& nodes,
                                   const std::string& partitions) {
  const std::string among = "," + partitions + ",";
  std::optional<int> most;
  for (const NodeShape& node : nodes) {
    const bool is_meant = partitions.empty()
                              ? node.is_default
                              : among.find("," + node.partition + ",") != std::string::npos;
    if (is_meant) most = std::max(most.value_or(0), node.processors);
  }
  return most;
}

SlurmSite parse_site(std::string_view text) {
  SlurmSite site;
  for (const std::string_view line : lines_of(text)) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    const std::string_view name = trimmed(line.substr(0, equals));
    const std::string_view value = trimmed(line.substr(equals + 1));
    if (name == "MaxArraySize") site.max_array_size = motion::as_number<int>(value).value_or(1001);
    if (name == "MaxJobCount") site.max_job_count = motion::as_number<int>(value).value_or(0);
    if (name == "RequeueExit") site.requeues_transient = has_code(value, worker_transient);
    if (name == "RequeueExitHold") site.holds_wrong_setup = has_code(value, worker_wrong_setup);
  }
  return site;
}

}  // namespace mien::pipeline
