#include "pipeline/reading/field_writer.h"

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
  const auto is_known = [&](const FieldEntry& entry) {
    if (entry.value.is_null()) return true;
    if ((entry.concerns & concerns::required) != 0) return false;
    return std::any_of(base.begin(), base.end(), [&](const FieldEntry& other) {
      return other.path == entry.path && other.value == entry.value;
    });
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
