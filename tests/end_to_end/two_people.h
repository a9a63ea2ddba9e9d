#pragma once

#include <string>

namespace mien::test {

/// A BVH file of two people, Ann and Bo, and one of the second alone.
struct TwoPeople {
  std::string both;
  std::string second;
};

/// The motions of two BVH files in one, as long as the shorter: the second person, Bo, moves two
/// units to the side.
TwoPeople two_people(const std::string& first_bvh, const std::string& second_bvh);

}  // namespace mien::test
