#include "motion/formats/reading/chosen_subject.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>

#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// The number that the whole text is, else 0.
std::size_t number_in(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end ? number : 0;
}

/// "Anna" and "Ben" of "Anna_Hips" and "Ben_Hips"; the names themselves unless all end alike, in a
/// word for the root.
std::vector<std::string> without_root(std::vector<std::string> names) {
  if (names.size() < 2) return names;
  const std::size_t separator = names.front().find_last_of("_:.- ");
  if (separator == std::string::npos) return names;
  const std::string ending = names.front().substr(separator);
  std::string word;
  for (const char c : ending.substr(1))
    word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool is_root = word == "hips" || word == "hip" || word == "pelvis" || word == "root";
  const bool is_common = std::ranges::all_of(names, [&](const std::string& name) {
    return name.size() > ending.size() && name.ends_with(ending);
  });
  if (is_root && is_common)
    for (std::string& name : names) name.resize(name.size() - ending.size());
  return names;
}

}  // namespace

std::vector<std::string> subject_names(const std::vector<std::string>& given) {
  const std::vector<std::string> names = without_root(given);
  std::vector<std::string> distinct;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string own = names[i].empty() ? "subject " + std::to_string(i + 1) : names[i];
    std::string name = own;
    for (std::size_t number = i + 1; !taken.insert(name).second; ++number)
      name = own + " " + std::to_string(number);
    distinct.push_back(std::move(name));
  }
  return distinct;
}

std::size_t chosen_subject(const Place& place, const std::vector<std::string>& names,
                           const std::optional<std::string>& wanted) {
  if (!wanted) return 0;
  const auto found = std::ranges::find(names, *wanted);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::size_t number = number_in(*wanted);
  if (number >= 1 && number <= names.size()) return number - 1;
  throw Error(place, "there is no subject " + in_quotes(*wanted),
              names.size() == 1 ? "it holds only " + in_quotes(names.front()) + ": omit the subject"
                                : "it holds " + listed(names) + ": choose one of these");
}

std::string note_on_subject(const std::vector<std::string>& names, std::size_t chosen,
                            const std::optional<std::string>& wanted) {
  if (wanted || names.size() < 2) return "";
  return "The file holds " + std::to_string(names.size()) + " people (" + listed(names) + "); " +
         in_quotes(names[chosen]) + " is used, because no subject was chosen.";
}

}  // namespace mien::motion
