#include "pipeline/base/documents/sha256.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

std::string sha256_of(std::string_view bytes) {
  Sha256 sha;
  sha.add(bytes);
  return sha.finish();
}

// The examples of FIPS 180-2, appendix B, and that of nothing.
TEST(Sha256, GivesPublishedValues) {
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotMindHowBytesCome) {
  Sha256 sha;
  for (int i = 0; i < 1000; ++i) sha.add(std::string(static_cast<std::size_t>(i % 7), 'x'));
  std::size_t all = 0;
  for (int i = 0; i < 1000; ++i) all += static_cast<std::size_t>(i % 7);
  EXPECT_EQ(sha.finish(), sha256_of(std::string(all, 'x')));
}

}  // namespace
}  // namespace mien::pipeline
