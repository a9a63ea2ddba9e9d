#include "pipeline/base/documents/fault.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

auto reading_order(const Fault& fault) {
  return std::tie(fault.place.file, fault.place.line, fault.place.column, fault.path, fault.wrong,
                  fault.remedy);
}

/// Longer than any sentence that mien itself writes.
constexpr std::size_t longest_sentence = 1000;

std::string sentence(std::string_view text) {
  return motion::excerpt(text, longest_sentence, motion::LineEnds::kept);
}

std::string wrong_with_path(const Fault& fault) {
  const std::string wrong = sentence(fault.wrong);
  return fault.path.empty() ? wrong : motion::excerpt(fault.path) + ": " + wrong;
}

Place shown_place(const Place& place) {
  return {motion::printable(place.file), place.line, place.column};
}

}  // namespace

std::string to_string(const Fault& fault) {
  return Error(shown_place(fault.place), wrong_with_path(fault), sentence(fault.remedy)).what();
}

std::string fault_lines(const std::vector<Fault>& faults, std::string_view beginning) {
  std::string text;
  for (std::size_t i = 0; i < faults.size() && i < most_listed_faults; ++i) {
    if (i > 0) text += '\n';
    text.append(beginning).append(to_string(faults[i]));
  }
  if (faults.size() <= most_listed_faults) return text;
  return text + "\nand " + std::to_string(faults.size() - most_listed_faults) + " more";
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
      faults_(in_reading_order(std::move(faults))),
      text_(fault_lines(faults_)) {}

std::string failure_text(const std::exception& failure) {
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&failure) != nullptr ||
                         dynamic_cast<const std::length_error*>(&failure) != nullptr;
  if (!is_memory) return failure.what();
  return "not enough memory; provide more, or use smaller images, shorter motions or fewer --jobs";
}

}  // namespace mien::pipeline
