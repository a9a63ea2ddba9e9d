#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mien::test {

/// "motion/gait" of "motion/gait/contact.h"; "motion" is the module's door.
using Room = std::string;

/// An #include line of one of the four modules that names a file of them.
struct IncludeLine {
  std::string file;  ///< relative to the tree
  int line = 0;      ///< from 1
  Room from;
  Room to;
};

/// What the rooms.txt of the modules allow, or their wings.txt.
struct RoomPlan {
  std::string file;  ///< "rooms.txt"
  /// The room, or the wing, that a room counts as.
  std::function<Room(const Room&)> place_of = [](const Room& room) { return room; };
  std::vector<Room> rooms;                ///< in the order of the files, lower floors first
  std::map<Room, std::set<Room>> arrows;  ///< room → rooms that it may include
};

std::vector<IncludeLine> include_lines(const std::filesystem::path& tree);

/// One sentence per fault, "motion/gait/contact.cpp:7: motion/gait may not include motion/lint
/// (motion/rooms.txt)": dependencies missing from the plan or unused, rooms that it does not list,
/// and rooms that depend on one of a higher floor. Throws std::runtime_error if a line of rooms.txt
/// is not "room: rooms | rooms of other modules".
std::vector<std::string> faults_of_rooms(const std::filesystem::path& tree);

/// Faults of the dependencies between wings, the groups of rooms in wings.txt.
std::vector<std::string> faults_of_wings(const std::filesystem::path& tree);

}  // namespace mien::test
