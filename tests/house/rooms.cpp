#include "house/rooms.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace mien::test {

namespace {

namespace fs = std::filesystem;

const std::string modules[] = {"motion", "render", "scenes", "pipeline"};

bool is_module(const std::string& name) {
  return std::find(std::begin(modules), std::end(modules), name) != std::end(modules);
}

std::string module_of(const Room& room) { return room.substr(0, room.find('/')); }

bool is_source(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".h";
}

Room room_of(const fs::path& file) { return file.parent_path().generic_string(); }

std::set<Room> rooms_in(const std::string& text, const std::string& prefix) {
  std::set<Room> rooms;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word != "-") rooms.insert(prefix + word);
  }
  return rooms;
}

void read_plan_line(const std::string& module, const std::string& line, RoomPlan& plan) {
  const size_t colon = line.find(": ");
  if (colon == std::string::npos) throw std::runtime_error(module + "/" + plan.file + ": " + line);
  const Room room = module + "/" + line.substr(0, colon);
  const std::string rest = line.substr(colon + 2);
  const size_t bar = std::min(rest.find('|'), rest.size());
  std::set<Room> arrows = rooms_in(rest.substr(0, bar), module + "/");
  if (bar < rest.size()) arrows.merge(rooms_in(rest.substr(bar + 1), ""));
  plan.rooms.push_back(room);
  plan.arrows[room] = std::move(arrows);
}

/// Sources of the modules, relative to the tree, in order.
std::vector<fs::path> sources_of(const fs::path& tree) {
  std::vector<fs::path> sources;
  for (const std::string& module : modules) {
    if (!fs::exists(tree / module)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree / module)) {
      if (is_source(entry.path())) sources.push_back(relative(entry.path(), tree));
    }
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

void add_include_lines(const fs::path& tree, const fs::path& file,
                       std::vector<IncludeLine>& lines) {
  static const std::regex include(R"re(\s*#\s*include\s+"([^"]+)".*)re");
  std::ifstream stream(tree / file);
  int number = 0;
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!std::regex_match(line, match, include)) continue;
    const Room to = room_of(match[1].str());
    if (is_module(module_of(to)))
      lines.push_back({file.generic_string(), number, room_of(file), to});
  }
}

/// The door of a module is open to all its rooms.
bool is_own_door(const IncludeLine& line) { return line.to == module_of(line.from); }

bool allowed(const RoomPlan& plan, const IncludeLine& line) {
  if (line.from == line.to || is_own_door(line)) return true;
  const auto arrows = plan.arrows.find(line.from);
  return arrows != plan.arrows.end() && arrows->second.contains(line.to);
}

void add_missing_arrows(const RoomPlan& plan, const std::vector<IncludeLine>& lines,
                        std::vector<std::string>& faults) {
  for (const IncludeLine& line : lines) {
    if (allowed(plan, line)) continue;
    faults.push_back(line.file + ":" + std::to_string(line.line) + ": " + line.from +
                     " may not include " + line.to + " (" + module_of(line.from) + "/" + plan.file +
                     ")");
  }
}

void add_unused_arrows(const RoomPlan& plan, const std::vector<IncludeLine>& lines,
                       std::vector<std::string>& faults) {
  std::set<std::pair<Room, Room>> used;
  for (const IncludeLine& line : lines) used.emplace(line.from, line.to);
  for (const auto& [from, arrows] : plan.arrows) {
    for (const Room& to : arrows) {
      if (!used.contains({from, to})) faults.push_back(from + " does not include " + to);
    }
  }
}

void add_unnamed_rooms(const fs::path& tree, const RoomPlan& plan,
                       std::vector<std::string>& faults) {
  for (const fs::path& file : sources_of(tree)) {
    const Room room = plan.place_of(room_of(file));
    if (!is_module(room) && !plan.arrows.contains(room))
      faults.push_back(file.generic_string() + ": " + plan.file + " does not name " + room);
  }
}

void add_higher_floors(const RoomPlan& plan, std::vector<std::string>& faults) {
  std::set<Room> below(std::begin(modules), std::end(modules));
  for (const Room& room : plan.rooms) {
    for (const Room& to : plan.arrows.at(room)) {
      if (!below.contains(to)) faults.push_back(room + " names " + to + ", which is not below it");
    }
    below.insert(room);
  }
}

/// "pipeline/base" of "pipeline/base/documents"; the other modules have no wings.
Room wing_of(const Room& room) {
  if (module_of(room) != "pipeline") return module_of(room);
  return room.substr(0, room.find('/', room.find('/') + 1));
}

RoomPlan read_plan(const fs::path& tree, RoomPlan plan) {
  for (const std::string& module : modules) {
    std::ifstream file(tree / module / plan.file);
    for (std::string line; std::getline(file, line);) {
      if (!line.empty() && line[0] != '#') read_plan_line(module, line, plan);
    }
  }
  return plan;
}

std::vector<std::string> faults_of(const fs::path& tree, const RoomPlan& plan) {
  std::vector<IncludeLine> lines = include_lines(tree);
  std::erase_if(lines, [&](const IncludeLine& line) {
    return !fs::exists(tree / module_of(line.from) / plan.file);
  });
  for (IncludeLine& line : lines) {
    line.from = plan.place_of(line.from);
    line.to = plan.place_of(line.to);
  }
  std::vector<std::string> faults;
  add_missing_arrows(plan, lines, faults);
  add_unused_arrows(plan, lines, faults);
  add_unnamed_rooms(tree, plan, faults);
  add_higher_floors(plan, faults);
  return faults;
}

}  // namespace

std::vector<IncludeLine> include_lines(const fs::path& tree) {
  std::vector<IncludeLine> lines;
  for (const fs::path& file : sources_of(tree)) add_include_lines(tree, file, lines);
  return lines;
}

std::vector<std::string> faults_of_rooms(const fs::path& tree) {
  return faults_of(tree, read_plan(tree, {.file = "rooms.txt"}));
}

std::vector<std::string> faults_of_wings(const fs::path& tree) {
  return faults_of(tree, read_plan(tree, {.file = "wings.txt", .place_of = wing_of}));
}

}  // namespace mien::test
