// The nodes of text FBX files (layout: fbx_document.h).

#include <algorithm>
#include <array>
#include <string>

#include "motion/formats/fbx/fbx_document.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// Kinds of characters, so that long lists of numbers are passed over quickly.
enum Class : unsigned char { other, space, numeric };

constexpr std::array<unsigned char, 256> classes = [] {
  std::array<unsigned char, 256> table{};
  for (const char c : {' ', '\t', '\r', '\n', '\v', '\f'}) table[static_cast<size_t>(c)] = space;
  for (const char c : {'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '+', '-', '.', ','}) {
    table[static_cast<size_t>(c)] = numeric;
  }
  return table;
}();

unsigned char class_of(char c) { return classes[static_cast<unsigned char>(c)]; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool ends_word(char c) {
  return class_of(c) == space || c == ',' || c == ':' || c == '{' || c == '}' || c == '"' ||
         c == ';';
}

struct TextTree {
  FbxDocument& document;
  std::string_view text;
  size_t at = 0;

  bool at_end() const { return at >= text.size(); }
  const char* here() const { return text.data() + at; }
};

[[noreturn]] void refuse_text(const TextTree& tree, size_t at, std::string_view wrong) {
  refuse_fbx(tree.document, tree.text.data() + at, wrong, fbx_again);
}

void skip_space_and_comments(TextTree& tree) {
  while (!tree.at_end()) {
    const char c = tree.text[tree.at];
    if (c == ';') {
      const size_t line_end = tree.text.find_first_of("\r\n", tree.at);
      tree.at = line_end == std::string_view::npos ? tree.text.size() : line_end;
    } else if (class_of(c) != space) {
      return;
    } else {
      ++tree.at;
    }
  }
}

/// Over numbers, commas and white space. An e belongs to a number only after a digit or a point.
void skip_numbers(TextTree& tree) {
  const char* const end = tree.text.data() + tree.text.size();
  const char* p = tree.here();
  for (; p < end; ++p) {
    if (class_of(*p) != other) continue;
    const bool is_exponent =
        (*p == 'e' || *p == 'E') && p > tree.here() && (is_digit(p[-1]) || p[-1] == '.');
    if (!is_exponent) break;
  }
  tree.at = static_cast<size_t>(p - tree.text.data());
}

void skip_quoted(TextTree& tree) {
  const size_t close = tree.text.find('"', tree.at + 1);
  if (close == std::string_view::npos) {
    refuse_text(tree, tree.at, "a text in quotes has no end; the file may be truncated");
  }
  tree.at = close + 1;
}

size_t word_end(const TextTree& tree, size_t at) {
  while (at < tree.text.size() && !ends_word(tree.text[at])) ++at;
  return at;
}

/// Over the values of a node, up to its brace or to the next name.
void skip_values(TextTree& tree) {
  for (;;) {
    skip_space_and_comments(tree);
    if (tree.at_end()) return;
    const char c = tree.text[tree.at];
    if (c == '"') {
      skip_quoted(tree);
    } else if (class_of(c) == numeric) {
      skip_numbers(tree);
    } else if (c == '{' || c == '}') {
      return;
    } else {
      const size_t end = word_end(tree, tree.at);
      if (end < tree.text.size() && tree.text[end] == ':') {
        if (end == tree.at) refuse_text(tree, tree.at, "a name is missing before a colon");
        return;
      }
      tree.at = end;
    }
  }
}

void parse_text_nodes(TextTree& tree, std::size_t depth);

void parse_text_node(TextTree& tree, std::size_t depth) {
  FbxDocument& document = tree.document;
  const size_t start = tree.at;
  const size_t end = word_end(tree, start);
  if (end == start || end >= tree.text.size() || tree.text[end] != ':') {
    refuse_text(tree, start,
                "expected a name and a colon instead of " +
                    in_quotes(tree.text.substr(start, std::max<size_t>(end - start, 1))));
  }
  if (depth > fbx_limits::deepest_node) {
    refuse_text(tree, start, "nodes are nested more than 64 deep");
  }
  if (document.nodes.size() >= fbx_limits::most_nodes) {
    refuse_text(tree, start, "the file has more than 4194304 nodes");
  }
  const size_t index = document.nodes.size();
  document.nodes.push_back({tree.text.substr(start, end - start), {}, 0, 0});
  tree.at = end + 1;
  const size_t list_start = tree.at;
  skip_values(tree);
  document.nodes[index].list = tree.text.substr(list_start, tree.at - list_start);
  if (!tree.at_end() && tree.text[tree.at] == '{') {
    const size_t brace = tree.at++;
    parse_text_nodes(tree, depth + 1);
    if (tree.at_end()) {
      refuse_text(tree, brace, "a brace is not closed; the file may be truncated");
    }
    ++tree.at;
  }
  document.nodes[index].end = static_cast<std::uint32_t>(document.nodes.size());
}

/// Up to the closing brace of the parent, or the end of the file.
void parse_text_nodes(TextTree& tree, std::size_t depth) {
  for (;;) {
    skip_space_and_comments(tree);
    if (tree.at_end() || tree.text[tree.at] == '}') return;
    parse_text_node(tree, depth);
  }
}

}  // namespace

void parse_text_fbx(FbxDocument& document) {
  TextTree tree{document, document.bytes};
  parse_text_nodes(tree, 1);
  if (!tree.at_end()) refuse_text(tree, tree.at, "a brace is closed that was not opened");
}

}  // namespace mien::motion
