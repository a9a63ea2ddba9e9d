#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

// Types for reading (field_reader.h), writing (field_writer.h) and naming (field_names.h) the
// options described in concerns.h.

/// JSON whose members keep their order.
using OrderedJson = nlohmann::ordered_json;

/// What is needed for reading a document besides its values.
struct ReadingContext {
  const Places& places;  ///< define the order of a map's members
  /// Resolves a path that is relative to the document's folder.
  std::function<std::filesystem::path(const std::string&)> resolve;
};

/// A value of a document that has been checked against the schema.
struct DocumentValue {
  const nlohmann::json& value;
  std::string path;  ///< "stimuli[2].output"
  const ReadingContext& context;
};

/// How values are written: as in a document, or for the key of an artifact. A key depends on a
/// file's name and contents: the name is written, and the file is added to `files`.
struct WritingOptions {
  bool for_key = false;
  std::vector<std::filesystem::path>* files = nullptr;
  std::filesystem::path folder = {};  ///< folder of the document; paths are written relative to it
  unsigned concerned = concerns::everything;  ///< options with none of these concerns are omitted
};

class FieldNames;

template <class Value>
concept HasFields = requires(FieldNames& names, Value& value) {
  fields_of(names, value);
};

/// Merges a document's value into `value` (field_reader.h).
template <class Value>
void read(const DocumentValue& given, Value& value);

/// A value as written in a document; null if it is omitted there (field_writer.h).
template <class Value>
OrderedJson written(const Value& value, const WritingOptions& how);

}  // namespace mien::pipeline
