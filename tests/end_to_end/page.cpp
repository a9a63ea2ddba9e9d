#include "end_to_end/page.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <sstream>

#include "end_to_end/program.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;

const std::regex code_between_backticks("`([^`]+)`");
const std::regex link_or_picture(R"(\]\(([^)\s]+)\))");

bool is_left_out(const fs::path& folder, const fs::path& root) {
  const std::string name = folder.filename().string();
  const bool at_root = folder.parent_path() == root;
  return name.starts_with('.') || name == "node_modules" ||
         (at_root && (name == "build" || name == "out"));
}

std::vector<std::string> found(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> all;
  for (std::sregex_iterator hit(text.begin(), text.end(), pattern), end; hit != end; ++hit) {
    all.push_back((*hit)[1]);
  }
  return all;
}

/// As GitHub does: lower case, spaces become hyphens, punctuation goes.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const unsigned char c : heading.substr(heading.find_first_not_of("# "))) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(c) || c == '-' || c == '_' || c >= 0x80)
      anchor += static_cast<char>(std::tolower(c));
  }
  return anchor;
}

void add_anchor(const std::string& anchor, std::set<std::string>& anchors) {
  std::string name = anchor;
  for (int again = 1; !anchors.insert(name).second; ++again) {
    name = anchor + "-" + std::to_string(again);
  }
}

/// Code spans first: what they show is no link.
void read_prose(const std::string& line, int number, Page& page) {
  if (line.starts_with('#')) add_anchor(anchor_of(line), page.anchors);
  for (const std::string& code : found(line, code_between_backticks)) page.code.push_back(code);
  const std::string prose = std::regex_replace(line, code_between_backticks, "");
  for (const std::string& target : found(prose, link_or_picture)) {
    page.links.push_back({target, number});
  }
}

int stated_code(const std::string& command) {
  std::smatch stated;
  return std::regex_search(command, stated, std::regex(R"(# exit code (\d+))"))
             ? std::stoi(stated[1])
             : 0;
}

bool is_command(const std::string& line) { return !line.empty() && !line.starts_with('#'); }

}  // namespace

std::vector<std::string> page_names() {
  const fs::path root = MIEN_SOURCE_DIR;
  std::vector<std::string> names;
  for (fs::recursive_directory_iterator at(root), end; at != end; ++at) {
    if (at->is_directory() && is_left_out(at->path(), root)) at.disable_recursion_pending();
    if (at->path().extension() == ".md") names.push_back(fs::relative(at->path(), root).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool is_followed(const std::string& name) {
  return name.starts_with("manifests/tutorials/") || name == "manifests/QUESTIONS.md";
}

Page read_page(const std::string& name) {
  Page page;
  page.name = name;
  std::istringstream lines(text_of(fs::path(MIEN_SOURCE_DIR) / name));
  bool in_block = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const bool fence = line.starts_with("```");
    if (fence && !in_block) page.blocks.push_back({line.substr(3), "", number});
    if (!fence && in_block) page.blocks.back().text += line + "\n";
    if (!fence && !in_block) read_prose(line, number, page);
    in_block ^= fence;
  }
  return page;
}

std::vector<PageBlock> blocks_of(const Page& page, const std::string& language) {
  std::vector<PageBlock> blocks;
  std::copy_if(page.blocks.begin(), page.blocks.end(), std::back_inserter(blocks),
               [&](const PageBlock& block) { return block.language == language; });
  return blocks;
}

std::vector<PageCommand> commands_of(const PageBlock& block) {
  std::vector<PageCommand> commands;
  std::istringstream lines(block.text);
  int number = block.line;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (is_command(line)) commands.push_back({line, number, stated_code(line)});
  }
  return commands;
}

std::vector<PageCommand> commands_of(const Page& page) {
  std::vector<PageCommand> commands;
  for (const PageBlock& block : blocks_of(page, "sh"))
    std::ranges::copy(commands_of(block), std::back_inserter(commands));
  return commands;
}

std::vector<std::string> top_level_parts(const std::string& yaml) {
  std::vector<std::string> parts;
  std::istringstream lines(yaml);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && std::isalpha(static_cast<unsigned char>(line[0]))) parts.emplace_back();
    if (!parts.empty()) parts.back() += line + "\n";
  }
  return parts;
}

std::string key_of(const std::string& part) { return part.substr(0, part.find(':')); }

}  // namespace mien::test
