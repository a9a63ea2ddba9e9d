// The nodes of binary FBX files (layout: fbx_document.h).

#include <cstring>
#include <string>

#include "motion/formats/fbx/fbx_document.h"
#include "motion/formats/fbx/fbx_values.h"
#include "motion/text/compressed_file.h"

namespace mien::motion {

namespace {

/// Where the parsing is.
struct BinaryCursor {
  FbxDocument& document;
  std::uint64_t at = 27;
  std::uint64_t inflated = 0;  ///< bytes that the arrays so far have once they are inflated
  std::uint64_t most_inflated =
      largest_inflated(document.bytes.size(), fbx_limits::most_inflated_bytes);

  const char* here() const { return document.bytes.data() + at; }
};

/// The fixed part of a node.
struct Record {
  std::uint64_t end = 0;
  std::uint64_t values = 0;
  std::uint64_t list_bytes = 0;
  std::uint8_t name_bytes = 0;
};

template <class Integer>
std::uint64_t unsigned_at(const char* bytes) {
  Integer value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

std::uint64_t record_size(const FbxDocument& document) {
  return document.version >= 7500 ? 25 : 13;
}

Record record_at(const BinaryCursor& cursor) {
  const char* bytes = cursor.here();
  if (cursor.document.version >= 7500) {
    return {unsigned_at<std::uint64_t>(bytes), unsigned_at<std::uint64_t>(bytes + 8),
            unsigned_at<std::uint64_t>(bytes + 16), static_cast<std::uint8_t>(bytes[24])};
  }
  return {unsigned_at<std::uint32_t>(bytes), unsigned_at<std::uint32_t>(bytes + 4),
          unsigned_at<std::uint32_t>(bytes + 8), static_cast<std::uint8_t>(bytes[12])};
}

/// Walks over the values of a node to see that they fill its list exactly.
void check_values(BinaryCursor& cursor, std::string_view list, std::uint64_t count) {
  size_t at = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const size_t size = binary_value_size(list.substr(at));
    if (size == 0) {
      refuse_fbx(cursor.document, list.data() + at,
                 "a value is of an unknown type or longer than its node", fbx_again);
    }
    const FbxArray array = binary_array(list.substr(at));
    cursor.inflated += array.inflated_bytes();
    const bool is_possible =
        array.count <= fbx_limits::most_elements &&
        (array.is_deflated
             ? array.inflated_bytes() / fbx_limits::most_inflation <= array.stored.size()
             : array.inflated_bytes() == array.stored.size());
    if (!is_possible || cursor.inflated > cursor.most_inflated) {
      refuse_fbx(cursor.document, list.data() + at,
                 "an array states " + std::to_string(array.count) +
                     " elements, which its bytes cannot hold or which are too many",
                 fbx_again);
    }
    at += size;
  }
  if (at != list.size()) {
    refuse_fbx(cursor.document, list.data() + at, "bytes are left over after a node's values",
               fbx_again);
  }
}

void parse_nodes_until(BinaryCursor& cursor, std::uint64_t end, std::size_t depth);

void parse_node(BinaryCursor& cursor, const Record& record, std::uint64_t parent_end,
                std::size_t depth) {
  FbxDocument& document = cursor.document;
  const std::uint64_t start = cursor.at;
  const std::uint64_t name_at = start + record_size(document);
  const bool fits = record.end > start && record.end <= parent_end && name_at <= record.end &&
                    record.name_bytes <= record.end - name_at &&
                    record.list_bytes <= record.end - name_at - record.name_bytes;
  if (!fits) {
    const bool is_cut = record.end > parent_end && parent_end == document.bytes.size();
    refuse_fbx(document, document.bytes.data() + start,
               is_cut ? "a node ends beyond the file, which may be truncated"
                      : "a node does not fit into its parent",
               fbx_again);
  }
  if (depth > fbx_limits::deepest_node) {
    refuse_fbx(document, document.bytes.data() + start, "nodes are nested more than 64 deep",
               fbx_again);
  }
  if (document.nodes.size() >= fbx_limits::most_nodes) {
    refuse_fbx(document, document.bytes.data() + start, "the file has more than 4194304 nodes",
               "export fewer objects");
  }
  const auto index = document.nodes.size();
  FbxNode node;
  node.name = document.bytes.substr(name_at, record.name_bytes);
  node.list = document.bytes.substr(name_at + record.name_bytes, record.list_bytes);
  check_values(cursor, node.list, record.values);
  node.value_count = static_cast<std::uint32_t>(record.values);
  document.nodes.push_back(node);
  cursor.at = name_at + record.name_bytes + record.list_bytes;
  if (cursor.at < record.end) parse_nodes_until(cursor, record.end, depth + 1);
  if (cursor.at != record.end) {
    refuse_fbx(document, cursor.here(), "a node's children end before the node", fbx_again);
  }
  document.nodes[index].end = static_cast<std::uint32_t>(document.nodes.size());
}

/// Parses siblings up to the record of zeros that ends them.
void parse_nodes_until(BinaryCursor& cursor, std::uint64_t end, std::size_t depth) {
  const std::uint64_t size = record_size(cursor.document);
  for (;;) {
    if (end - cursor.at < size) {
      refuse_fbx(cursor.document, cursor.here(),
                 "a list of nodes has no end; the file may be truncated", fbx_again);
    }
    const Record record = record_at(cursor);
    if (record.end == 0) {
      cursor.at += size;
      return;
    }
    parse_node(cursor, record, end, depth);
  }
}

}  // namespace

void parse_binary_fbx(FbxDocument& document) {
  BinaryCursor cursor{document};
  parse_nodes_until(cursor, document.bytes.size(), 1);
}

}  // namespace mien::motion
