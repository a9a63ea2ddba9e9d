#include "pipeline/documents/fault.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace mien::pipeline {

namespace {

auto reading_order(const Fault& fault) {
  return std::tie(fault.place.file, fault.place.line, fault.place.column, fault.path, fault.wrong,
                  fault.remedy);
}

std::string wrong_with_path(const Fault& fault) {
  return fault.path.empty() ? fault.wrong : fault.path + ": " + fault.wrong;
}

}  // namespace

std::string to_string(const Fault& fault) {
  return Error(fault.place, wrong_with_path(fault), fault.remedy).what();
}

std::vector<Fault> in_reading_order(std::vector<Fault> faults) {
  std::sort(faults.begin(), faults.end(), [](const Fault& left, const Fault& right) {
    return reading_order(left) < reading_order(right);
  });
  const auto same = [](const Fault& left, const Fault& right) {
    return reading_order(left) == reading_order(right);
  };
  faults.erase(std::unique(faults.begin(), faults.end(), same), faults.end());
  return faults;
}

Faults::Faults(std::vector<Fault> faults)
    : Error(faults.front().place, wrong_with_path(faults.front()), faults.front().remedy),
      faults_(in_reading_order(std::move(faults))) {
  for (const Fault& fault : faults_) {
    if (!text_.empty()) text_ += '\n';
    text_ += to_string(fault);
  }
}

}  // namespace mien::pipeline
