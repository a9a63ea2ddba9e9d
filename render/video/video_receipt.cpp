#include "render/video/video_receipt.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include <xxhash.h>

namespace mien::render {

namespace {

using Bytes = std::span<const std::uint8_t>;

/// A hash of units: of their lengths and bytes.
class UnitHash {
 public:
  UnitHash() : state_(XXH3_createState(), XXH3_freeState) { XXH3_64bits_reset(state_.get()); }

  void add(Bytes unit) {
    const std::uint64_t length = unit.size();
    XXH3_64bits_update(state_.get(), &length, sizeof length);
    XXH3_64bits_update(state_.get(), unit.data(), unit.size());
  }

  std::uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

/// Units after a length of four bytes each. After one that is cut short comes a unit of nothing.
std::uint64_t hash_by_lengths(Bytes bytes) {
  UnitHash hash;
  while (bytes.size() >= 4) {
    std::size_t length = 0;
    for (const std::uint8_t byte : bytes.first(4)) length = length << 8 | byte;
    bytes = bytes.subspan(4);
    if (length > bytes.size()) break;
    hash.add(bytes.first(length));
    bytes = bytes.subspan(length);
    if (bytes.empty()) return hash.value();
  }
  hash.add(bytes);
  hash.add({});
  return hash.value();
}

/// Units after a mark of zeros and a one, as ITU-T H.264 (annex B) has them; within them no two
/// zeros are followed by a one.
std::uint64_t hash_by_marks(Bytes bytes) {
  constexpr std::uint8_t mark[] = {0, 0, 1};
  const auto next_mark = [&](auto from) {
    return std::search(from, bytes.end(), std::begin(mark), std::end(mark));
  };
  UnitHash hash;
  for (auto at = next_mark(bytes.begin()); at != bytes.end();) {
    const auto begin = at + std::size(mark);
    at = next_mark(begin);
    auto end = at;
    while (end != begin && *std::prev(end) == 0) --end;  // units do not end with zeros
    hash.add({begin, end});
  }
  return hash.value();
}

/// Without the mark before a frame (a temporal delimiter: its header, and its size, which is 0).
Bytes without_av1_mark(Bytes bytes) {
  const bool marked = bytes.size() >= 2 && bytes[0] == 0x12 && bytes[1] == 0;
  return marked ? bytes.subspan(2) : bytes;
}

}  // namespace

bool has_packet_per_frame(VideoKind kind) { return !traits_of(kind).picture; }

std::uint64_t hash_of(const Image8& picture) {
  return XXH3_64bits(picture.channels.data(), picture.channels.size());
}

std::uint64_t packet_hash(std::string_view codec, Bytes bytes, bool has_lengths) {
  if (codec == "h264") return has_lengths ? hash_by_lengths(bytes) : hash_by_marks(bytes);
  if (codec == "av1") bytes = without_av1_mark(bytes);
  return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace mien::render
