#include "motion/text/frame_file_name.h"

#include <cstddef>
#include <string_view>

#include "motion/text/as_number.h"
#include "motion/text/compressed_file.h"

namespace mien::motion {

std::optional<FrameFileName> frame_file_name(const std::filesystem::path& file) {
  constexpr std::string_view ending = "_keypoints.json";
  constexpr std::size_t number_digits = 12;
  constexpr std::size_t after = number_digits + ending.size();
  const std::string name = without_compression(file).filename().string();
  if (!name.ends_with(ending) || name.size() < after + 2) return std::nullopt;
  const std::size_t mark = name.size() - after - 1;
  const std::string digits = name.substr(mark + 1, number_digits);
  if (name[mark] != '_' || digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  return FrameFileName{name.substr(0, mark), *as_number<std::int64_t>(digits)};
}

}  // namespace mien::motion
