// Any bytes are the contents of a gzip file or are refused, and whatever they are is a kind of file
// that each reader takes or refuses.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "motion/error.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_kind.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t most = std::size_t{1} << 20;
  const std::string_view file(reinterpret_cast<const char*>(bytes), size);
  std::string contents(file);
  if (is_gzip(file)) {
    try {
      contents = inflated(file, "fuzz.gz", most);
    } catch (const mien::Error&) {
    }
    // Its size is looked at after each piece.
    if (contents.size() > most + (std::size_t{1} << 18) && contents != file) std::abort();
  }
  for (const char* format :
       {"bvh", "amc", "gltf", "fbx", "mvnx", "c3d", "trc", "npy", "npz", "json", "csv"}) {
    try {
      require_kind(contents, "fuzz", format);
    } catch (const mien::Error&) {
    }
  }
  return 0;
}
