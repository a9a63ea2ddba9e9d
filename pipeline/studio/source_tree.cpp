#include "pipeline/studio/source_tree.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "pipeline/documents/fault.h"
#include "pipeline/reading/yaml_places.h"
#include "pipeline/reading/yaml_tree.h"

namespace mien::pipeline {

namespace {

using Kind = SourceNode::Kind;

bool is_blank(char letter) { return letter == ' ' || letter == '\t'; }
bool is_break(char letter) { return letter == '\n' || letter == '\r'; }

/// A collection that is not closed yet.
struct OpenSource {
  SourceNode node;
  std::optional<SourceNode> key;
};

/// Builds the tree from the parser's events, without ends.
class SourceBuilder : public YAML::EventHandler {
 public:
  SourceBuilder(std::string_view text, const YamlPlaces& places) : text_(text), places_(places) {}

  SourceNode take_root() {
    mark_used(root_);
    return std::move(root_);
  }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(node_at(mark, Kind::null, anchor));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    SourceNode node = node_at(mark, Kind::alias, anchor);
    used_.emplace(anchor, node.place.line);
    add(std::move(node));
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    SourceNode node = node_at(mark, Kind::scalar, anchor);
    node.text = value;
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    stack_.push_back({node_at(mark, Kind::sequence, anchor), {}});
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    stack_.push_back({node_at(mark, Kind::map, anchor), {}});
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  SourceNode node_at(const YAML::Mark& mark, Kind kind, YAML::anchor_t anchor) {
    SourceNode node;
    node.kind = kind;
    node.place = places_.at(mark);
    const std::string_view rest = places_.text_from(mark);
    node.begin = rest.empty() ? text_.size() : static_cast<std::size_t>(rest.data() - text_.data());
    node.anchor = anchor;
    return node;
  }

  void close() {
    SourceNode closed = std::move(stack_.back().node);
    stack_.pop_back();
    add(std::move(closed));
  }

  void add(SourceNode node) {
    if (stack_.empty()) {
      root_ = std::move(node);
      return;
    }
    OpenSource& open = stack_.back();
    if (open.node.kind == Kind::map && !open.key) {
      open.key = std::move(node);
      return;
    }
    if (open.key) open.node.keys.push_back(std::move(*open.key));
    open.key.reset();
    open.node.children.push_back(std::move(node));
  }

  void mark_used(SourceNode& node) const {
    const auto used = used_.find(node.anchor);
    if (node.anchor != 0 && node.kind != Kind::alias && used != used_.end())
      node.used_again = used->second;
    for (SourceNode& child : node.children) mark_used(child);
  }

  std::string_view text_;
  const YamlPlaces& places_;
  SourceNode root_;
  std::vector<OpenSource> stack_;
  std::map<std::size_t, int> used_;  ///< anchor → line of its first alias
};

/// Finds where values end. Positions that it is not sure of are found out later: whatever is
/// written with their help is read again and compared.
class Ends {
 public:
  explicit Ends(std::string_view text) : text_(text) {}

  /// `outer`: column of the keys or dashes about it, -1 at the root.
  void find(SourceNode& node, bool in_flow, int outer) const {
    node.content = behind_properties(node);
    switch (node.kind) {
      case Kind::null:
        node.end = node.begin;
        break;
      case Kind::alias:
        node.end = end_of_word(node.begin);
        break;
      case Kind::scalar:
        node.end = end_of_scalar(node.content, in_flow, outer);
        break;
      case Kind::sequence:
      case Kind::map:
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
    if (node.kind == Kind::alias || node.kind == Kind::null) return i;
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
    if (key.kind == Kind::alias) key.end = end_of_word(key.begin);
    if (value.kind != Kind::null)
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
      if (node.kind == Kind::map) {
        find_member(node, i);
        last = std::max(node.keys[i].end, node.children[i].end);
      } else if (node.children[i].kind == Kind::null) {
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

SourceNode read_source(std::string_view text, const std::string& file) {
  std::vector<Fault> faults;
  read_yaml(text, file, faults);
  if (!faults.empty()) throw Faults(in_reading_order(std::move(faults)));
  const YamlPlaces places(text, file);
  std::istringstream stream{std::string(text)};
  YAML::Parser parser(stream);
  SourceBuilder builder(text, places);
  parser.HandleNextDocument(builder);
  SourceNode root = builder.take_root();
  Ends(text).find(root, false, -1);
  return root;
}

}  // namespace mien::pipeline
