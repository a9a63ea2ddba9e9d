#include "pipeline/base/reading/yaml_tree.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/utf8.h"
#include "pipeline/base/reading/yaml_places.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_bytes = 16 << 20;
constexpr std::size_t most_values = 1'000'000;
constexpr std::size_t deepest = 100;
constexpr std::size_t longest_key = 200;

/// Leaves the parser after a fault that makes the rest meaningless.
struct Abandoned {};

/// Long texts count as several values, so that the budget bounds memory too.
std::size_t count_values(const YamlNode& node) {
  std::size_t count = 1 + node.text.size() / 256;
  for (const YamlNode& key : node.keys) count += count_values(key);
  for (const YamlNode& child : node.children) count += count_values(child);
  return count;
}

bool is_merge_key(const YamlNode& key) { return !key.quoted && key.text == "<<"; }

/// A collection that is not closed yet.
struct OpenNode {
  YamlNode node;
  YAML::anchor_t anchor = 0;
  // For maps only:
  std::map<std::string, int, std::less<>> lines;  ///< of the keys so far
  std::optional<YamlNode> key;                    ///< key whose value has not been read yet
  bool skips_value = false;                       ///< the key was invalid
  std::vector<YamlNode> merged;                   ///< values of `<<`
};

/// Whether a quoted scalar ends. (The parser takes the end of the file for its closing quote.)
bool is_closed(std::string_view text) {
  const char quote = text.empty() ? '\0' : text[0];
  if (quote != '"' && quote != '\'') return true;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (text[i] == quote && quote == '\'' && text.substr(i, 2) == "''") {
      ++i;
    } else if (text[i] == quote) {
      return true;
    }
  }
  return false;
}

/// Builds the tree from the parser's events.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const YamlPlaces& places, std::vector<Fault>& faults)
      : places_(places), faults_(faults) {}

  YamlNode take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(node_at(mark, YamlNode::Kind::null), anchor);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode node = node_at(mark, YamlNode::Kind::scalar);
    node.text = value;
    node.quoted = tag == "!" || tag == "tag:yaml.org,2002:str";
    if (!node.quoted) refuse_tag(tag, node.place);
    if (node.quoted && !is_closed(places_.text_from(mark)))
      fault(node.place, "a quote that is not closed", "add the closing quote");
    add(std::move(node), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchored_.find(anchor);
    if (found == anchored_.end()) {
      fault(places_.at(mark), "this alias is inside the value that it refers to",
            "write the value out");
      throw Abandoned{};
    }
    YamlNode copy = found->second;
    copy.place = places_.at(mark);
    value_count_ += count_values(copy);
    refuse_too_many(copy.place);
    attach(std::move(copy));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::sequence);
  }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::map);
  }

  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  YamlNode node_at(const YAML::Mark& mark, YamlNode::Kind kind) {
    YamlNode node;
    node.kind = kind;
    node.place = places_.at(mark);
    ++value_count_;
    refuse_too_many(node.place);
    return node;
  }

  void fault(const Place& place, std::string wrong, std::string remedy) {
    faults_.push_back({place, "", std::move(wrong), std::move(remedy)});
  }

  void refuse_too_many(const Place& place) {
    if (value_count_ <= most_values) return;
    fault(place, "the document unfolds to more than 1,000,000 values",
          "write fewer anchors and aliases");
    throw Abandoned{};
  }

  void refuse_tag(const std::string& tag, const Place& place) {
    if (tag.empty() || tag == "?") return;
    if (tag.starts_with("tag:yaml.org,2002:")) return;
    fault(place, "the tag " + motion::excerpt(tag) + " has no meaning here", "omit it");
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
            YamlNode::Kind kind) {
    OpenNode collection;
    collection.node = node_at(mark, kind);
    collection.anchor = anchor;
    refuse_tag(tag == "!" ? "" : tag, collection.node.place);
    if (stack_.size() >= deepest) {
      fault(collection.node.place, "nested deeper than 100 levels", "flatten it");
      throw Abandoned{};
    }
    stack_.push_back(std::move(collection));
  }

  void close() {
    OpenNode closed = std::move(stack_.back());
    stack_.pop_back();
    for (const YamlNode& source : closed.merged) merge(closed, source);
    add(std::move(closed.node), closed.anchor);
  }

  void add(YamlNode node, YAML::anchor_t anchor) {
    if (anchor != 0) {
      // What has a name is kept a second time, and so is all that has one within it.
      value_count_ += count_values(node);
      refuse_too_many(node.place);
      anchored_[anchor] = node;
    }
    attach(std::move(node));
  }

  void attach(YamlNode node) {
    if (stack_.empty()) {
      root_ = std::move(node);
    } else if (stack_.back().node.kind == YamlNode::Kind::sequence) {
      stack_.back().node.children.push_back(std::move(node));
    } else if (!stack_.back().key) {
      begin_member(stack_.back(), std::move(node));
    } else {
      end_member(stack_.back(), std::move(node));
    }
  }

  void begin_member(OpenNode& map, YamlNode key) {
    map.skips_value = true;
    if (key.kind != YamlNode::Kind::scalar) {
      fault(key.place, "a key must be plain text", "write \"name: value\"");
    } else if (key.text.size() > longest_key) {
      fault(key.place, "a key of more than 200 bytes", "shorten it");
    } else if (const auto first = map.lines.find(key.text); first != map.lines.end()) {
      fault(key.place,
            motion::in_quotes(key.text) + " is already given on line " +
                std::to_string(first->second),
            "keep one of the two");
    } else {
      map.skips_value = false;
    }
    map.key = std::move(key);
  }

  void end_member(OpenNode& map, YamlNode value) {
    YamlNode key = std::move(*map.key);
    map.key.reset();
    if (map.skips_value) return;
    if (is_merge_key(key)) {
      map.merged.push_back(std::move(value));
    } else {
      map.lines.emplace(key.text, key.place.line);
      map.node.keys.push_back(std::move(key));
      map.node.children.push_back(std::move(value));
    }
  }

  /// Adds the members of `source` that the map does not have itself.
  void merge(OpenNode& map, const YamlNode& source) {
    if (source.kind == YamlNode::Kind::sequence) {
      for (const YamlNode& one : source.children) merge(map, one);
    } else if (source.kind != YamlNode::Kind::map) {
      fault(source.place, "\"<<\" merges maps only", "name the anchor of a map");
    } else {
      for (std::size_t i = 0; i < source.keys.size(); ++i) {
        const YamlNode& key = source.keys[i];
        if (!map.lines.emplace(key.text, key.place.line).second) continue;
        map.node.keys.push_back(key);
        map.node.children.push_back(source.children[i]);
      }
    }
  }

  const YamlPlaces& places_;
  std::vector<Fault>& faults_;
  YamlNode root_;
  std::vector<OpenNode> stack_;
  std::map<YAML::anchor_t, YamlNode> anchored_;
  std::size_t value_count_ = 0;
};

/// The first tab among the spaces that begin a line, up to `last_line`.
std::optional<Place> tab_in_indentation(const YamlPlaces& places, const Place& last) {
  for (int line = 1; line <= last.line; ++line) {
    const std::string_view text = places.line(line);
    const std::size_t stop = text.find_first_not_of(' ');
    if (stop == std::string_view::npos || text[stop] != '\t') continue;
    return Place{last.file, line, static_cast<int>(stop) + 1};
  }
  return std::nullopt;
}

/// Whether a question mark precedes a comma or a bracket, which the parser takes for a sign of YAML
/// inside [ ] and { }.
bool has_question_in_brackets(std::string_view line) {
  for (std::size_t at = line.find('?'); at != line.npos; at = line.find('?', at + 1)) {
    const std::size_t next = line.find_first_not_of(' ', at + 1);
    if (next != line.npos && std::string_view(",]}").find(line[next]) != std::string_view::npos)
      return true;
  }
  return false;
}

/// The parser's fault at its mark, or an earlier fault that explains it better.
Fault syntax_fault(const YamlPlaces& places, const YAML::ParserException& error) {
  const Place place = places.at(error.mark);
  if (const auto tab = tab_in_indentation(places, place))
    return {*tab, "", "a tab in the indentation", "use spaces"};
  const std::string_view line = places.line(place.line);
  const bool expands = line.find("${") != std::string_view::npos;
  return {place, "",
          "not valid YAML: " + motion::excerpt(error.msg, 2 * motion::max_quoted_characters),
          expands ? "put \"${…}\" in quotes inside [ ] and { }"
          : has_question_in_brackets(line)
              ? "put texts that end with ? in quotes inside [ ] and { }"
              : "check quotes, brackets, colons and indentation up to here"};
}

std::optional<Fault> refuse_text(std::string_view text, const std::string& file) {
  const Place whole{file, 0, 0};
  if (text.size() > most_bytes) return Fault{whole, "", "larger than 16 MiB", "split it"};
  if (const auto place = first_invalid_utf8(text))
    return Fault{{file, place->line, place->column}, "", "not UTF-8 text", "save it as UTF-8"};
  return std::nullopt;
}

YamlNode parse(std::string_view text, const YamlPlaces& places, const std::string& file,
               std::vector<Fault>& faults) {
  std::istringstream stream{std::string(text)};
  YAML::Parser parser(stream);
  TreeBuilder builder(places, faults);
  if (!parser.HandleNextDocument(builder)) {
    faults.push_back({{file, 1, 1}, "", "the file is empty", "write a document into it"});
    return {};
  }
  YamlNode root = builder.take_root();
  TreeBuilder second(places, faults);
  if (parser.HandleNextDocument(second))
    faults.push_back({second.take_root().place, "", "a second document begins here",
                      "keep one document in a file"});
  return root;
}

}  // namespace

YamlNode read_yaml(std::string_view text, const std::string& file, std::vector<Fault>& faults) {
  if (auto fault = refuse_text(text, file)) {
    faults.push_back(std::move(*fault));
    return {};
  }
  const YamlPlaces places(text, file);
  try {
    return parse(text, places, file, faults);
  } catch (const YAML::ParserException& error) {
    faults.push_back(syntax_fault(places, error));
  } catch (const Abandoned&) {
    // Its fault is in the list.
  }
  return {};
}

}  // namespace mien::pipeline
