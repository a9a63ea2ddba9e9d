#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

// What passes between a document and the structs whose options concerns.h lists: read by
// field_reader.h, written by field_writer.h, named by field_names.h.

/// Text that is written in a fixed order.
using OrderedJson = nlohmann::ordered_json;

/// What reading a document needs beside its values.
struct ReadingContext {
  const Places& places;  ///< they tell in which order the members of a map were written
  std::function<std::filesystem::path(const std::string&)> resolve;  ///< from the document's folder
};

/// A value of a document that the schema has been held against.
struct Given {
  const nlohmann::json& value;
  std::string path;  ///< "stimuli[2].output"
  const ReadingContext& context;
};

/// How values are written: as a document says them, or for the key of an artifact. There, a file
/// counts by its name and contents: the name is written, and the file is added to `files`.
struct Writing {
  bool for_key = false;
  std::vector<std::filesystem::path>* files = nullptr;
  std::filesystem::path folder = {};          ///< of the document; paths are written from there
  unsigned concerned = concerns::everything;  ///< options that concern none of these are left out
};

class FieldNames;

template <class Value>
concept HasFields = requires(FieldNames& names, Value& value) {
  fields_of(names, value);
};

/// Lays what is given over a value (field_reader.h).
template <class Value>
void read(const Given& given, Value& value);

/// A value as a document would say it; null where that says nothing (field_writer.h).
template <class Value>
OrderedJson written(const Value& value, const Writing& how);

}  // namespace mien::pipeline
