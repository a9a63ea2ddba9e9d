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

/// The faults of several lists in reading order. Where a list has a fault of a value, the faults
/// that later lists have of the same value are left out: they follow from it.
std::vector<Fault> merged_faults(std::vector<std::vector<Fault>> lists);

/// Faults of one document, found by its checks one after the other.
class FaultList {
 public:
  /// `places` must outlive the list.
  explicit FaultList(const Places& places) : places_(places) {}

  std::vector<Fault> take() { return std::move(faults_); }

  /// At the value, or at the nearest one around it that was written.
  void add(const std::string& path, std::string wrong, std::string remedy);
  /// At a member's name.
  void add_at_key(const std::string& path, std::string wrong, std::string remedy);

  bool was_given(const std::string& path) const { return places_.values.contains(path); }

  /// A name that must be among those that are known. None are known when something else is at
  /// fault, and has been told.
  void check_word(const std::string& path, const std::string& name, const std::string& what,
                  const std::vector<std::string>& known);
  /// A file that must be there and have no more bytes than that; `expected` says what may be named.
  void check_file(const std::string& path, const std::filesystem::path& file,
                  const std::string& expected, std::uintmax_t most_bytes);

 private:
  const Places& places_;
  std::vector<Fault> faults_;
};

}  // namespace mien::pipeline
