#include "pipeline/study/studio/source_change.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "pipeline/study/studio/yaml_text.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;
using Kind = SourceNode::Kind;
using ChangeKind = DocumentChange::Kind;

constexpr std::size_t none = static_cast<std::size_t>(-1);

[[noreturn]] void refuse_alias(const SourceNode& node) {
  throw Error(node.place, "this value stands elsewhere in the file, behind an alias",
              "write the value out here, or change it by hand where its anchor is");
}

void refuse_used_again(const SourceNode& node) {
  if (node.kind == Kind::alias || node.used_again == 0) return;
  throw Error(node.place,
              "this value is used again by the alias on line " + std::to_string(node.used_again),
              "write the value out there, or change it by hand");
}

std::size_t member_at(const SourceNode& map, const std::string& name) {
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    if (map.keys[i].kind == Kind::scalar && map.keys[i].text == name) return i;
  }
  return none;
}

bool has_merge_key(const SourceNode& map) { return member_at(map, "<<") != none; }

[[noreturn]] void refuse_missing(const SourceNode& parent, const std::string& name) {
  if (has_merge_key(parent))
    throw Error(parent.place, "\"" + name + "\" comes from the merge key << of this map",
                "write the value out here, or change it by hand where its anchor is");
  throw Error(parent.place, "there is no \"" + name + "\" here", "load the file again");
}

/// Where a change takes place: a collection, and which of its children.
struct Spot {
  const SourceNode& parent;
  std::size_t index;  ///< none: a member that is not there
  std::string name;   ///< of a member
};

std::size_t index_in(const SourceNode& parent, const DocumentStep& step) {
  if (parent.kind == Kind::alias) refuse_alias(parent);
  refuse_used_again(parent);
  if (const auto* name = std::get_if<std::string>(&step))
    return parent.kind == Kind::map ? member_at(parent, *name) : none;
  const std::size_t index = std::get<std::size_t>(step);
  return parent.kind == Kind::sequence ? index : none;
}

Spot spot_of(const SourceNode& root, const DocumentPath& path) {
  const SourceNode* parent = &root;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const std::size_t index = index_in(*parent, path[i]);
    if (index >= parent->children.size()) refuse_missing(*parent, path_text({path[i]}));
    parent = &parent->children[index];
  }
  const auto* name = std::get_if<std::string>(&path.back());
  return {*parent, index_in(*parent, path.back()), name != nullptr ? *name : ""};
}

/// The changes of a text about one spot.
class SpotChange {
 public:
  SpotChange(std::string_view text, const Spot& spot) : text_(text), spot_(spot) {}

  TextChange replaced(const ordered_json& value) const;
  TextChange added_member(const ordered_json& value) const;
  TextChange inserted(const ordered_json& value) const;
  TextChange removed() const;

 private:
  const SourceNode& parent() const { return spot_.parent; }
  std::size_t count() const { return parent().children.size(); }

  /// With the key's or the element's own first byte, in flow.
  std::size_t begin_of(std::size_t i) const {
    return parent().kind == Kind::map ? parent().keys[i].begin : parent().children[i].begin;
  }
  std::size_t end_of(std::size_t i) const {
    const std::size_t end = parent().children[i].end;
    return parent().kind == Kind::map ? std::max(parent().keys[i].end, end) : end;
  }

  /// In block style: of the key or the dash. An element's anchor may stand lines below its dash.
  std::size_t head_of(std::size_t i) const {
    if (parent().kind == Kind::map) return begin_of(i);
    for (std::size_t line = begin_of_line(text_, begin_of(i));;) {
      const std::size_t dash = line + parent().column;
      if (dash < text_.size() && text_[dash] == '-' && dash < begin_of(i)) return dash;
      if (line == 0) return begin_of(i);
      line = begin_of_line(text_, line - 1);
    }
  }

  std::string line_break() const {
    const std::size_t first = text_.find('\n');
    return first != std::string_view::npos && first > 0 && text_[first - 1] == '\r' ? "\r\n" : "\n";
  }

  /// With this file's line breaks.
  std::string with_breaks(const std::string& lines) const {
    if (line_break() == "\n") return lines;
    std::string text;
    for (const char letter : lines) text += letter == '\n' ? "\r\n" : std::string(1, letter);
    return text;
  }

  TextChange at(std::size_t begin, std::size_t end, std::string text) const {
    const bool is_there = spot_.index < count();
    return {begin, end, std::move(text),
            is_there ? parent().children[spot_.index].place : parent().place};
  }

  TextChange emptied() const {
    if (parent().is_flow) return at(begin_of(0), end_of(0), "");
    return at(parent().content, parent().end, parent().kind == Kind::map ? "{}" : "[]");
  }

  void refuse_lost_comment(std::size_t begin, std::size_t end) const {
    const std::string_view lost = text_.substr(begin, end - begin);
    if (lost.find('#') == std::string_view::npos) return;
    throw Error(parent().children[spot_.index].place,
                "a comment beside this value would be lost with it",
                "move the comment, or take the value out of the file by hand");
  }

  std::string_view text_;
  const Spot& spot_;
};

TextChange SpotChange::replaced(const ordered_json& value) const {
  const SourceNode& old = parent().children[spot_.index];
  refuse_used_again(old);
  std::string text = yaml_line(value);
  const char first = old.content < text_.size() ? text_[old.content] : ' ';
  if (old.kind == Kind::scalar && value.is_string() && (first == '"' || first == '\''))
    text = quoted_yaml(value.get<std::string>(), first);
  if (old.begin == old.end) text = " " + text;
  if (old.begin == old.end && old.end < text_.size() && text_[old.end] == '#') text += " ";
  const bool is_long = old.content - begin_of_line(text_, old.content) + text.size() > yaml_width;
  if (is_long && !parent().is_flow && parent().kind == Kind::map && old.kind != Kind::null) {
    const std::string margin = "\n" + std::string(parent().column + 2, ' ');
    const std::string lines = yaml_lines(value, parent().column + 2, yaml_width - margin.size());
    const bool is_on_line =
        begin_of_line(text_, old.content) == begin_of_line(text_, parent().keys[spot_.index].begin);
    if (lines.find('\n') != std::string::npos)
      text = with_breaks((is_on_line ? margin : "") + lines);
  }
  return at(old.content, old.end, text);
}

TextChange SpotChange::added_member(const ordered_json& value) const {
  if (parent().kind != Kind::map)
    throw Error(parent().place, "there is no map here to put \"" + spot_.name + "\" into",
                "write \"{}\" here, or the value by hand");
  if (parent().is_flow) {
    const std::string member = yaml_line(spot_.name) + ": " + yaml_line(value);
    if (count() == 0) return at(parent().content + 1, parent().content + 1, member);
    const std::size_t end = end_of(count() - 1);
    return at(end, end, ", " + member);
  }
  const std::size_t end = end_of_line(text_, end_of(count() - 1));
  const std::string margin = "\n" + std::string(parent().column, ' ');
  return at(end, end, with_breaks(margin + yaml_member(spot_.name, value, parent().column)));
}

TextChange SpotChange::inserted(const ordered_json& value) const {
  if (parent().kind != Kind::sequence)
    throw Error(parent().place, "there is no list here to put something into",
                "write \"[]\" here, or the value by hand");
  if (parent().is_flow) {
    const std::string element = yaml_line(value);
    if (count() == 0) return at(parent().content + 1, parent().content + 1, element);
    if (spot_.index == 0) return at(begin_of(0), begin_of(0), element + ", ");
    const std::size_t end = end_of(spot_.index - 1);
    return at(end, end, ", " + element);
  }
  const std::string margin(parent().column, ' ');
  const std::string element = with_breaks("- " + yaml_element(value, parent().column + 2));
  if (spot_.index == 0) {
    const std::size_t begin = head_of(0);
    return at(begin, begin, element + line_break() + margin);
  }
  const std::size_t end = end_of_line(text_, end_of(spot_.index - 1));
  return at(end, end, line_break() + margin + element);
}

TextChange SpotChange::removed() const {
  const std::size_t i = spot_.index;
  refuse_used_again(parent().children[i]);
  if (count() == 1) return emptied();
  if (parent().is_flow) {
    const bool is_last = i + 1 == count();
    const std::size_t begin = is_last ? end_of(i - 1) : begin_of(i);
    const std::size_t end = is_last ? end_of(i) : begin_of(i + 1);
    if (is_last) {
      refuse_lost_comment(begin, begin_of(i));
    } else {
      refuse_lost_comment(end_of(i), end);
    }
    return at(begin, end, "");
  }
  const std::size_t head = head_of(i), line = begin_of_line(text_, head);
  const bool has_line =
      text_.substr(line, head - line).find_first_not_of(' ') == std::string_view::npos;
  if (!has_line) {  // the first, behind a dash
    refuse_lost_comment(end_of_line(text_, end_of(i)), head_of(i + 1));
    return at(head, head_of(i + 1), "");
  }
  const std::size_t end = end_of_line(text_, end_of(i));
  const std::size_t next = text_.find('\n', end);
  if (next != std::string_view::npos) return at(line, next + 1, "");
  return at(line == 0 ? 0 : end_of_line(text_, line - 1), text_.size(),
            "");  // the file's last line
}

}  // namespace

TextChange text_change(std::string_view text, const SourceNode& root,
                       const DocumentChange& change) {
  if (change.path.empty())
    throw Error(root.place, "the whole document cannot be changed at once", "write it by hand");
  const Spot spot = spot_of(root, change.path);
  const SpotChange spot_change(text, spot);
  const bool is_there = spot.index < spot.parent.children.size();
  const bool is_member = !spot.name.empty();
  if (change.kind == ChangeKind::insert && spot.index <= spot.parent.children.size())
    return spot_change.inserted(change.value);
  if (change.kind == ChangeKind::set && is_there) return spot_change.replaced(change.value);
  if (change.kind == ChangeKind::set && is_member) return spot_change.added_member(change.value);
  if (change.kind == ChangeKind::remove && is_there) return spot_change.removed();
  refuse_missing(spot.parent, path_text({change.path.back()}));
}

}  // namespace mien::pipeline
