#include "pipeline/base/reading/field_writer.h"

#include <algorithm>

namespace mien::pipeline {

namespace {

void put(OrderedJson& map, const std::string& path, const OrderedJson& value) {
  const std::size_t dot = path.find('.');
  if (dot == std::string::npos) {
    map[path] = value;
  } else {
    put(map[path.substr(0, dot)], path.substr(dot + 1), value);
  }
}

}  // namespace

std::vector<FieldEntry> differences(std::vector<FieldEntry> entries,
                                    const std::vector<FieldEntry>& base) {
  auto next = base.begin();
  const auto in_base = [&](const std::string& path) {
    const auto is_it = [&](const FieldEntry& other) { return other.path == path; };
    auto found = std::find_if(next, base.end(), is_it);
    if (found == base.end()) found = std::find_if(base.begin(), next, is_it);
    const bool is_there = found != base.end() && is_it(*found);
    if (is_there) next = found + 1;
    return is_there ? &*found : nullptr;
  };
  const auto is_known = [&](const FieldEntry& entry) {
    if (entry.value.is_null()) return true;
    if ((entry.concerns & concerns::required) != 0) return false;
    const FieldEntry* other = in_base(entry.path);
    return other != nullptr && other->value == entry.value;
  };
  std::erase_if(entries, is_known);
  return entries;
}

OrderedJson nested_map(const std::vector<FieldEntry>& entries) {
  OrderedJson map = OrderedJson::object();
  for (const FieldEntry& entry : entries) put(map, entry.path, entry.value);
  return map;
}

}  // namespace mien::pipeline
