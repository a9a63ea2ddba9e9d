#include "pipeline/farm/memory_amount.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

namespace mien::pipeline {

namespace {

struct MemoryAmount {
  long long number = 0;
  char unit = 'M';  ///< "M" is Slurm's own

  double kibibytes() const {
    constexpr std::string_view units = "KMGT";
    return static_cast<double>(number) * std::pow(1024.0, static_cast<double>(units.find(unit)));
  }
};

std::optional<MemoryAmount> memory_amount(const std::string& text) {
  MemoryAmount amount;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, amount.number);
  constexpr long long most = 1'000'000'000'000;
  if (error != std::errc{} || amount.number <= 0 || amount.number > most) return std::nullopt;
  const std::string letters(rest, end);
  if (letters.empty()) return amount;
  const std::size_t unit = std::string_view("KMGTkmgt").find(letters);
  if (letters.size() != 1 || unit == std::string_view::npos) return std::nullopt;
  amount.unit = "KMGT"[unit % 4];
  return amount;
}

}  // namespace

std::string doubled_memory(const std::string& memory) {
  const std::optional<MemoryAmount> amount = memory_amount(memory);
  return amount ? std::to_string(2 * amount->number) + amount->unit : "";
}

std::string larger_memory(const std::string& one, const std::string& other) {
  const std::optional<MemoryAmount> first = memory_amount(one);
  const std::optional<MemoryAmount> second = memory_amount(other);
  if (!second) return one;
  return first && first->kibibytes() >= second->kibibytes() ? one : other;
}

}  // namespace mien::pipeline
