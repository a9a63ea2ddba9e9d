#include "pipeline/study/studio/source_tree.h"

#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/yaml_places.h"
#include "pipeline/base/reading/yaml_tree.h"
#include "pipeline/study/studio/source_ends.h"

namespace mien::pipeline {

namespace {

using SourceKind = SourceNode::Kind;

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
    add(node_at(mark, SourceKind::null, anchor));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    SourceNode node = node_at(mark, SourceKind::alias, anchor);
    used_.emplace(anchor, node.place.line);
    add(std::move(node));
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    SourceNode node = node_at(mark, SourceKind::scalar, anchor);
    node.text = value;
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    stack_.push_back({node_at(mark, SourceKind::sequence, anchor), {}});
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    stack_.push_back({node_at(mark, SourceKind::map, anchor), {}});
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  SourceNode node_at(const YAML::Mark& mark, SourceKind kind, YAML::anchor_t anchor) {
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
    if (open.node.kind == SourceKind::map && !open.key) {
      open.key = std::move(node);
      return;
    }
    if (open.key) open.node.keys.push_back(std::move(*open.key));
    open.key.reset();
    open.node.children.push_back(std::move(node));
  }

  void mark_used(SourceNode& node) const {
    const auto used = used_.find(node.anchor);
    if (node.anchor != 0 && node.kind != SourceKind::alias && used != used_.end())
      node.used_again = used->second;
    for (SourceNode& child : node.children) mark_used(child);
  }

  std::string_view text_;
  const YamlPlaces& places_;
  SourceNode root_;
  std::vector<OpenSource> stack_;
  std::map<std::size_t, int> used_;  ///< anchor → line of its first alias
};

}  // namespace

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
  find_ends(text, root);
  return root;
}

}  // namespace mien::pipeline
