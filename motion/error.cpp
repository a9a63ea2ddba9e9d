#include "motion/error.h"

namespace mien {

std::string to_string(const Place& place) {
  std::string text = place.file;
  if (place.line > 0) text.append(":").append(std::to_string(place.line));
  if (place.line > 0 && place.column > 0) text.append(":").append(std::to_string(place.column));
  return text;
}

namespace {

std::string sentence(const Place& place, std::string_view wrong, std::string_view remedy) {
  std::string text = to_string(place);
  if (!text.empty()) text += ": ";
  text += wrong;
  if (!remedy.empty()) text.append("; ").append(remedy);
  return text;
}

}  // namespace

Error::Error(Place place, std::string_view wrong, std::string_view remedy)
    : std::runtime_error(sentence(place, wrong, remedy)), place_(std::move(place)) {}

}  // namespace mien
