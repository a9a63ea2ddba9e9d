#include "pipeline/study/studio/document_change.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;
using Changes = std::vector<DocumentChange>;
using ChangeKind = DocumentChange::Kind;

ordered_json& child_at(ordered_json& parent, const DocumentStep& step) {
  if (const auto* name = std::get_if<std::string>(&step)) {
    if (!parent.is_object() || !parent.contains(*name)) throw std::out_of_range(*name);
    return parent[*name];
  }
  const std::size_t index = std::get<std::size_t>(step);
  if (!parent.is_array() || index >= parent.size()) throw std::out_of_range("no such element");
  return parent[index];
}

void apply_to_element(const DocumentChange& change, std::size_t index, ordered_json& array) {
  const bool is_insert = change.kind == ChangeKind::insert;
  if (!array.is_array() || index >= array.size() + (is_insert ? 1 : 0))
    throw std::out_of_range("no such element");
  const auto at = array.begin() + static_cast<std::ptrdiff_t>(index);
  if (is_insert) {
    array.insert(at, change.value);
  } else if (change.kind == ChangeKind::remove) {
    array.erase(at);
  } else {
    array[index] = change.value;
  }
}

DocumentPath below(DocumentPath path, DocumentStep step) {
  path.push_back(std::move(step));
  return path;
}

/// Elements that are the same one, changed or not.
bool correspond(const ordered_json& one, const ordered_json& other) {
  if (one.is_object() && other.is_object() && one.contains("id") && other.contains("id"))
    return one["id"] == other["id"];
  return say_the_same(one, other);
}

/// Pairs of corresponding elements, ascending in both: as many as there are (longest common
/// subsequence).
std::vector<std::pair<std::size_t, std::size_t>> correspondences(const ordered_json& from,
                                                                 const ordered_json& to) {
  const std::size_t rows = from.size(), columns = to.size();
  std::vector<std::vector<std::size_t>> longest(rows + 1, std::vector<std::size_t>(columns + 1));
  std::vector<std::vector<bool>> same(rows, std::vector<bool>(columns));
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;) {
      same[i][j] = correspond(from[i], to[j]);
      longest[i][j] =
          same[i][j] ? longest[i + 1][j + 1] + 1 : std::max(longest[i + 1][j], longest[i][j + 1]);
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0, j = 0; i < rows && j < columns;) {
    if (same[i][j]) {
      pairs.emplace_back(i++, j++);
    } else if (longest[i + 1][j] >= longest[i][j + 1]) {
      ++i;
    } else {
      ++j;
    }
  }
  return pairs;
}

void compare(const ordered_json& from, const ordered_json& to, const DocumentPath& path,
             Changes& changes);

void compare_maps(const ordered_json& from, const ordered_json& to, const DocumentPath& path,
                  Changes& changes) {
  for (const auto& [key, value] : to.items()) {
    if (!from.contains(key)) {
      changes.push_back({ChangeKind::set, below(path, key), value});
    } else {
      compare(from[key], value, below(path, key), changes);
    }
  }
  for (const auto& [key, value] : from.items()) {
    if (!to.contains(key)) changes.push_back({ChangeKind::remove, below(path, key), {}});
  }
}

/// From the last element to the first, so that indices of what is yet to be changed stay.
void compare_arrays(const ordered_json& from, const ordered_json& to, const DocumentPath& path,
                    Changes& changes) {
  auto pairs = correspondences(from, to);
  std::size_t end = from.size(), end_to = to.size();
  const auto change_gap = [&](std::size_t begin, std::size_t begin_to) {
    const std::size_t common = std::min(end - begin, end_to - begin_to);
    for (std::size_t i = end; i > begin + common; --i)
      changes.push_back({ChangeKind::remove, below(path, i - 1), {}});
    for (std::size_t j = end_to; j > begin_to + common; --j)
      changes.push_back({ChangeKind::insert, below(path, begin + common), to[j - 1]});
    for (std::size_t i = common; i-- > 0;)
      compare(from[begin + i], to[begin_to + i], below(path, begin + i), changes);
  };
  for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
    change_gap(pair->first + 1, pair->second + 1);
    compare(from[pair->first], to[pair->second], below(path, pair->first), changes);
    end = pair->first;
    end_to = pair->second;
  }
  change_gap(0, 0);
}

void compare(const ordered_json& from, const ordered_json& to, const DocumentPath& path,
             Changes& changes) {
  if (from.is_object() && to.is_object()) {
    compare_maps(from, to, path, changes);
  } else if (from.is_array() && to.is_array()) {
    compare_arrays(from, to, path, changes);
  } else if (!say_the_same(from, to)) {
    changes.push_back({ChangeKind::set, path, to});
  }
}

}  // namespace

std::string path_text(const DocumentPath& path) {
  std::string text;
  for (const DocumentStep& step : path) {
    if (const auto* name = std::get_if<std::string>(&step)) {
      text += (text.empty() ? "" : ".") + *name;
    } else {
      text += "[" + std::to_string(std::get<std::size_t>(step)) + "]";
    }
  }
  return text;
}

void apply(const DocumentChange& change, ordered_json& document) {
  if (change.path.empty()) {
    document = change.value;
    return;
  }
  ordered_json* parent = &document;
  for (std::size_t i = 0; i + 1 < change.path.size(); ++i)
    parent = &child_at(*parent, change.path[i]);
  if (const auto* index = std::get_if<std::size_t>(&change.path.back()))
    return apply_to_element(change, *index, *parent);
  const std::string& name = std::get<std::string>(change.path.back());
  if (!parent->is_object()) throw std::out_of_range(name);
  if (change.kind == ChangeKind::set) {
    (*parent)[name] = change.value;
  } else if (change.kind == ChangeKind::insert || parent->erase(name) == 0) {
    throw std::out_of_range(name);
  }
}

Changes changes_between(const ordered_json& from, const ordered_json& to) {
  Changes changes;
  compare(from, to, {}, changes);
  return changes;
}

bool say_the_same(const ordered_json& one, const ordered_json& other) {
  if (one.is_number() && other.is_number()) return one.get<double>() == other.get<double>();
  if (one.type() != other.type() || one.size() != other.size()) return false;
  if (one.is_array()) {
    return std::equal(one.begin(), one.end(), other.begin(), say_the_same);
  }
  if (!one.is_object()) return one == other;
  for (const auto& [key, value] : one.items()) {
    if (!other.contains(key) || !say_the_same(value, other[key])) return false;
  }
  return true;
}

}  // namespace mien::pipeline
