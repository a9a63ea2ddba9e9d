#include "motion/formats/stated_unit.h"

#include <string>

#include "motion/formats/acclaim/acclaim.h"
#include "motion/formats/acclaim/acclaim_skeleton.h"
#include "motion/formats/fbx/fbx_scene.h"
#include "motion/formats/motion_file.h"
#include "motion/text/file_contents.h"

namespace mien::motion {

std::optional<double> stated_unit(const std::filesystem::path& path) {
  const std::string ending = lower_case_ending(path);
  if (ending == ".fbx") {
    const std::string bytes = read_contents(path);
    return parse_fbx_settings(parse_fbx_document(bytes, path.string())).stated_metres_per_unit;
  }
  if (ending != ".amc") return std::nullopt;
  const std::filesystem::path asf = find_asf(path);
  const double metres = parse_asf(read_contents(asf), asf.string()).metres_per_unit;
  // A file with unit 1 says nothing of its lengths.
  return metres == 1.0 ? std::nullopt : std::optional(metres);
}

}  // namespace mien::motion
