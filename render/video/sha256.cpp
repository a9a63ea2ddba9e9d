#include "render/video/sha256.h"

#include <array>
#include <cstdint>
#include <new>

extern "C" {
#include <libavutil/mem.h>
#include <libavutil/sha.h>
}

namespace mien::render {

struct Sha256::State {
  State() : sha(av_sha_alloc()) {
    if (sha == nullptr) throw std::bad_alloc();
    av_sha_init(sha, 256);
  }
  ~State() { av_free(sha); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  AVSHA* sha;
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::string_view bytes) {
  av_sha_update(state_->sha, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::string Sha256::finish() {
  std::array<std::uint8_t, 32> digest{};
  av_sha_final(state_->sha, digest.data());
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

}  // namespace mien::render
