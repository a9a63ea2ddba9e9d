#include "pipeline/study/studio/source_ends.h"

#include <algorithm>
#include <cstddef>

namespace mien::pipeline {

namespace {

using SourceKind = SourceNode::Kind;

bool is_blank(char letter) { return letter == ' ' || letter == '\t'; }
bool is_break(char letter) { return letter == '\n' || letter == '\r'; }

class Ends {
 public:
  explicit Ends(std::string_view text) : text_(text) {}

  /// `outer`: column of the keys or dashes about it, -1 at the root.
  void find(SourceNode& node, bool in_flow, int outer) const {
    node.content = behind_properties(node);
    switch (node.kind) {
      case SourceKind::null:
        node.end = node.begin;
        break;
      case SourceKind::alias:
        node.end = end_of_word(node.begin);
        break;
      case SourceKind::scalar:
        node.end = end_of_scalar(node.content, in_flow, outer);
        break;
      case SourceKind::sequence:
      case SourceKind::map:
        find_collection(node, in_flow);
        break;
    }
  }

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\n'; }

  std::size_t behind_space(std::size_t i) const {
    while (i < text_.size() && (is_blank(text_[i]) || is_break(text_[i]))) ++i;
    return i;
  }

  /// Also over comments.
  std::size_t behind_gap(std::size_t i) const {
    for (i = behind_space(i); at(i) == '#' && i < text_.size(); i = behind_space(i))
      i = end_of_line(text_, i);
    return i;
  }

  std::size_t end_of_word(std::size_t i) const {
    const auto goes_on = [&] {
      return !is_blank(text_[i]) && !is_break(text_[i]) &&
             std::string_view(",[]{}").find(text_[i]) == std::string_view::npos;
    };
    while (i < text_.size() && goes_on()) ++i;
    return i;
  }

  std::size_t behind_properties(const SourceNode& node) const {
    std::size_t i = node.begin;
    if (node.kind == SourceKind::alias || node.kind == SourceKind::null) return i;
    while (at(i) == '&' || at(i) == '!') i = behind_gap(end_of_word(i));
    return i;
  }

  std::size_t end_of_quoted(std::size_t i) const {
    const char quote = text_[i++];
    for (; i < text_.size(); ++i) {
      if (text_[i] == '\\' && quote == '"') {
        ++i;
      } else if (text_[i] == quote) {
        if (quote == '"' || at(i + 1) != '\'') return i + 1;
        ++i;
      }
    }
    return i;
  }

  std::size_t end_of_plain_on_line(std::size_t i, bool in_flow) const {
    const std::size_t begin = i;
    for (; i < text_.size() && !is_break(text_[i]); ++i) {
      if (text_[i] == '#' && i > begin && is_blank(text_[i - 1])) break;
      const bool ends_key =
          is_blank(at(i + 1)) || is_break(at(i + 1)) ||
          (in_flow && std::string_view(",[]{}").find(at(i + 1)) != std::string_view::npos);
      if (text_[i] == ':' && ends_key) break;
      if (in_flow && std::string_view(",[]{}").find(text_[i]) != std::string_view::npos) break;
    }
    while (i > begin && is_blank(text_[i - 1])) --i;
    return i;
  }

  /// Of lines that are indented further than `outer`: the end of the last with something on it.
  std::size_t end_of_indented(std::size_t i, int outer, bool to_comment) const {
    std::size_t end = end_of_line(text_, i);
    if (to_comment) end = end_of_plain_on_line(i, false);
    for (std::size_t line = end_of_line(text_, i); line < text_.size();) {
      line += at(line) == '\r' ? 2 : 1;
      std::size_t first = line;
      while (first < text_.size() && text_[first] == ' ') ++first;
      const bool is_empty = first >= text_.size() || is_break(text_[first]);
      if (!is_empty && static_cast<int>(first - line) <= outer) break;
      if (!is_empty && to_comment && text_[first] == '#') break;
      line = end_of_line(text_, first);
      if (!is_empty) end = to_comment ? end_of_plain_on_line(first, false) : line;
    }
    return end;
  }

  std::size_t end_of_scalar(std::size_t i, bool in_flow, int outer) const {
    if (at(i) == '"' || at(i) == '\'') return end_of_quoted(i);
    if (in_flow) return end_of_plain_on_line(i, true);
    if (at(i) == '|' || at(i) == '>') return end_of_indented(i, outer, false);
    return end_of_indented(i, outer, true);
  }

  /// A value that is not there, or one of the words for nothing.
  void find_null(SourceNode& node, std::size_t from, bool in_flow) const {
    std::size_t i = from;
    while (is_blank(at(i))) ++i;
    for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
      if (!text_.substr(i).starts_with(word)) continue;
      if (end_of_plain_on_line(i, in_flow) != i + word.size()) continue;
      node.begin = node.content = i;
      node.end = i + word.size();
      return;
    }
    node.begin = node.content = node.end = from;
  }

  void find_member(SourceNode& map, std::size_t i) const {
    SourceNode& key = map.keys[i];
    SourceNode& value = map.children[i];
    key.content = behind_properties(key);
    key.end = at(key.content) == '"' || at(key.content) == '\''
                  ? end_of_quoted(key.content)
                  : end_of_plain_on_line(key.content, map.is_flow);
    if (key.kind == SourceKind::alias) key.end = end_of_word(key.begin);
    if (value.kind != SourceKind::null)
      return find(value, map.is_flow, map.is_flow ? -1 : static_cast<int>(map.column));
    std::size_t colon = key.end;
    while (is_blank(at(colon))) ++colon;
    find_null(value, at(colon) == ':' ? colon + 1 : key.end, map.is_flow);
  }

  void find_collection(SourceNode& node, bool in_flow) const {
    node.is_flow = in_flow || at(node.content) == '{' || at(node.content) == '[';
    if (!node.is_flow) {
      if (!node.keys.empty()) node.content = node.keys.front().begin;
      node.column = node.content - begin_of_line(text_, node.content);
    }
    std::size_t last = node.content + 1;
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      if (node.kind == SourceKind::map) {
        find_member(node, i);
        last = std::max(node.keys[i].end, node.children[i].end);
      } else if (node.children[i].kind == SourceKind::null) {
        node.children[i].begin = node.children[i].content = node.children[i].end = last;
      } else {
        find(node.children[i], node.is_flow, node.is_flow ? -1 : static_cast<int>(node.column));
        last = node.children[i].end;
      }
    }
    node.end = last;
    if (!node.is_flow) return;
    std::size_t close = behind_gap(last);
    if (at(close) == ',') close = behind_gap(close + 1);
    node.end = close + 1;
  }

  std::string_view text_;
};

}  // namespace

std::size_t end_of_line(std::string_view text, std::size_t at) {
  std::size_t end = std::min(text.find('\n', at), text.size());
  if (end > at && text[end - 1] == '\r') --end;
  return end;
}

std::size_t begin_of_line(std::string_view text, std::size_t at) {
  const std::size_t line_break = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return line_break == std::string_view::npos ? (text.starts_with("\xEF\xBB\xBF") ? 3 : 0)
                                              : line_break + 1;
}

void find_ends(std::string_view text, SourceNode& root) { Ends(text).find(root, false, -1); }

}  // namespace mien::pipeline
