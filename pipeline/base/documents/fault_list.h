#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

/// Adds faults at the end.
void append(std::vector<Fault>& faults, std::vector<Fault> more);

/// The faults of several lists in reading order. If a list has a fault for a value, faults of later
/// lists for the same value are dropped as consequences.
std::vector<Fault> merged_faults(std::vector<std::vector<Fault>> lists);

/// Collects the faults of one document over all its checks.
class FaultList {
 public:
  /// `places` must outlive the list.
  explicit FaultList(const Places& places) : places_(places) {}

  std::vector<Fault> take() { return std::move(faults_); }

  /// Adds a fault at a value's location or, if the document does not contain the value, at that of
  /// the nearest enclosing one.
  void add(const std::string& path, std::string wrong, std::string remedy);
  /// Adds a fault at the location of a member's name.
  void add_at_key(const std::string& path, std::string wrong, std::string remedy);

  bool was_given(const std::string& path) const { return places_.values.contains(path); }

  /// Adds a fault unless `name` is among `known`; `what` is the kind of name: "example". Does
  /// nothing if `known` is empty, since the reason for that has been reported already.
  void check_known_name(const std::string& path, const std::string& name, const std::string& what,
                        const std::vector<std::string>& known);
  /// Adds a fault unless `file` is a regular file of at most `most_bytes` bytes. `expected` names
  /// the kind of file that the remedy asks for: "a motion file".
  void check_file(const std::string& path, const std::filesystem::path& file,
                  const std::string& expected, std::uintmax_t most_bytes);

 private:
  const Places& places_;
  std::vector<Fault> faults_;
};

}  // namespace mien::pipeline
