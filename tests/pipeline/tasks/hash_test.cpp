#include "pipeline/tasks/hash.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

// XXH128 of the empty input with seed 0, from the reference implementation's own tests.
TEST(Hash, OfNothingIsThePublishedOne) {
  EXPECT_EQ(hash_of(std::string_view{}), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash, OfAFileIsThatOfItsBytes) {
  const test::TemporaryFolder folder;
  std::mt19937 random(3);
  for (const std::size_t size : {0u, 1u, 65535u, 65536u, 200000u}) {
    std::string bytes(size, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    write_file(folder.path() / "f", bytes);
    EXPECT_EQ(hash_of_file(folder.path() / "f"), hash_of(bytes)) << size;
  }
  EXPECT_THROW(hash_of_file(folder.path() / "missing"), std::system_error);
}

}  // namespace
}  // namespace mien::pipeline
