#pragma once

#include <set>
#include <string>
#include <vector>

namespace mien::test {

/// A fenced code block: ```sh … ```.
struct PageBlock {
  std::string language;  ///< "sh", "yaml" or none
  std::string text;
  int line = 0;  ///< of the opening fence, from 1
};

/// A link or a picture: [text](target), ![text](target).
struct PageLink {
  std::string target;
  int line = 0;
};

/// One line of an sh block.
struct PageCommand {
  std::string text;
  int line = 0;
  int code = 0;  ///< exit code stated in a comment: "# exit code 1"
};

/// A parsed Markdown file.
struct Page {
  std::string name;  ///< from the source folder: "motion/README.md"
  std::vector<PageBlock> blocks;
  std::vector<PageLink> links;
  std::set<std::string> anchors;  ///< of its headings, as they stand behind # in a link
  std::vector<std::string> code;  ///< inline code, between single backticks
};

/// Names of all Markdown files of the sources, sorted; build/, out/, hidden folders and those of
/// npm left out.
std::vector<std::string> page_names();

/// Whether a page is followed from its beginning to its end (tutorials_test.cpp).
bool is_followed(const std::string& name);

Page read_page(const std::string& name);
std::vector<PageBlock> blocks_of(const Page& page, const std::string& language);
std::vector<PageCommand> commands_of(const PageBlock& block);
std::vector<PageCommand> commands_of(const Page& page);

/// Parts of a YAML text that begin at its left edge: {"look: {…}\n", "output:\n  size: …\n"}.
std::vector<std::string> top_level_parts(const std::string& yaml);

/// The key that a part begins with.
std::string key_of(const std::string& part);

}  // namespace mien::test
