#include "end_to_end/two_people.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace mien::test {

namespace {

struct BvhParts {
  std::string hierarchy;  ///< without its heading
  std::string frame_time;
  std::vector<std::string> frames;
};

BvhParts parts_of(const std::string& bvh, const std::string& root_joint) {
  std::istringstream in(bvh);
  BvhParts parts;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line) && line != "MOTION")
    parts.hierarchy += (line.starts_with("ROOT") ? "ROOT " + root_joint : line) + "\n";
  std::getline(in, line);
  std::getline(in, parts.frame_time);
  while (std::getline(in, line)) parts.frames.push_back(line);
  return parts;
}

/// A frame with another x of the root, its first number.
std::string moved_aside(const std::string& frame) {
  std::istringstream numbers(frame);
  double x = 0.0;
  std::string rest;
  numbers >> x;
  std::getline(numbers, rest);
  return std::to_string(x + 2.0) + rest;
}

}  // namespace

TwoPeople two_people(const std::string& first_bvh, const std::string& second_bvh) {
  const BvhParts first = parts_of(first_bvh, "Ann"), second = parts_of(second_bvh, "Bo");
  const std::size_t count = std::min(first.frames.size(), second.frames.size());
  const std::string counts =
      "MOTION\nFrames: " + std::to_string(count) + "\n" + first.frame_time + "\n";
  TwoPeople people = {"HIERARCHY\n" + first.hierarchy + second.hierarchy + counts,
                      "HIERARCHY\n" + second.hierarchy + counts};
  for (std::size_t f = 0; f < count; ++f) {
    const std::string frame = moved_aside(second.frames[f]) + "\n";
    people.both += first.frames[f] + " " + frame;
    people.second += frame;
  }
  return people;
}

}  // namespace mien::test
