#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/formats/gltf/gltf.h"
#include "motion/gltf_text.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

using nlohmann::json;

using Bytes = std::vector<unsigned char>;

/// A binary glTF file taken apart.
struct Parts {
  json document;
  std::string buffer;
};

Parts parts_of(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  return {json::parse(glb.substr(20, length)), glb.substr(20 + length + 8)};
}

size_t bytes_of_element(const json& accessor) {
  const std::string type = accessor["type"];
  const size_t numbers = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
  return numbers * (accessor["componentType"] == 5123 ? 2 : 4);
}

Bytes packed_vertices(const std::string& bytes, size_t count, size_t stride) {
  Bytes packed(meshopt_encodeVertexBufferBound(count, stride));
  packed.resize(
      meshopt_encodeVertexBuffer(packed.data(), packed.size(), bytes.data(), count, stride));
  return packed;
}

Bytes packed_triangles(const std::string& bytes) {
  std::vector<unsigned int> indices(bytes.size() / 4);
  std::memcpy(indices.data(), bytes.data(), bytes.size());
  Bytes packed(meshopt_encodeIndexBufferBound(indices.size(), indices.size()));
  packed.resize(
      meshopt_encodeIndexBuffer(packed.data(), packed.size(), indices.data(), indices.size()));
  return packed;
}

/// The file with all of its buffer views packed, as gltfpack and gltf-transform write it.
json packed(const std::string& glb, const std::string& extension) {
  Parts parts = parts_of(glb);
  std::string all;
  for (const json& accessor : parts.document["accessors"]) {
    json& view = parts.document["bufferViews"][accessor["bufferView"].get<size_t>()];
    const std::string bytes = parts.buffer.substr(view["byteOffset"], view["byteLength"]);
    const size_t stride = bytes_of_element(accessor);
    const bool is_triangles = view.value("target", 0) == 34963;
    const Bytes small = is_triangles ? packed_triangles(bytes)
                                     : packed_vertices(bytes, bytes.size() / stride, stride);
    view["buffer"] = 1;
    view["extensions"][extension] = {{"buffer", 0},
                                     {"byteOffset", all.size()},
                                     {"byteLength", small.size()},
                                     {"byteStride", stride},
                                     {"count", bytes.size() / stride},
                                     {"mode", is_triangles ? "TRIANGLES" : "ATTRIBUTES"}};
    all.append(small.begin(), small.end());
  }
  const size_t length = parts.document["buffers"][0]["byteLength"];
  parts.document["buffers"] = {
      {{"byteLength", all.size()},
       {"uri", "data:application/octet-stream;base64," + mien::test::base64(all)}},
      {{"byteLength", length}, {"extensions", {{extension, {{"fallback", true}}}}}}};
  parts.document["extensionsRequired"] = {extension};
  return parts.document;
}

Recording random_figure(unsigned seed) {
  std::mt19937_64 random(seed);
  return mien::test::random_recording(random, {.joints = 9, .frames = 40, .moving_offsets = true});
}

void expect_same(const Recording& a, const Recording& b) {
  ASSERT_EQ(a.skeleton.size(), b.skeleton.size());
  ASSERT_EQ(a.frame_count(), b.frame_count());
  EXPECT_LT(mien::test::largest_joint_distance(a, b), 1e-12);
  EXPECT_LT(mien::test::largest_turn(a, b), 1e-12);
}

TEST(GltfPackedByMeshopt, IsReadAsIfItWereNot) {
  for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      const std::string glb = to_glb(random_figure(seed));
      const json small = packed(glb, extension);
      expect_same(parse_gltf(small.dump(), "small.gltf"), parse_gltf(glb, "large.glb"));
    }
  }
}

TEST(GltfPackedByMeshopt, MayHaveItsRotationsAndPlacesFiltered) {
  const Recording recording = random_figure(3);
  const size_t frames = recording.poses.size();
  const std::string glb = to_glb(recording);
  json small = packed(glb, "EXT_meshopt_compression");
  const Parts parts = parts_of(glb);
  std::string all;
  for (json& accessor : small["accessors"]) {
    if (accessor["type"] != "VEC4" || accessor["count"] != frames) continue;
    const size_t index = accessor["bufferView"];
    std::vector<float> turns(4 * frames);
    std::memcpy(
        turns.data(),
        parts.buffer.data() + parts.document["bufferViews"][index]["byteOffset"].get<size_t>(),
        16 * frames);
    std::string filtered(8 * frames, '\0');
    meshopt_encodeFilterQuat(filtered.data(), frames, 8, 16, turns.data());
    const Bytes bytes = packed_vertices(filtered, frames, 8);
    accessor["componentType"] = 5122;
    accessor["normalized"] = true;
    json& view = small["bufferViews"][index]["extensions"]["EXT_meshopt_compression"];
    view = {{"buffer", 2},           {"byteOffset", all.size()}, {"byteLength", bytes.size()},
            {"byteStride", 8},       {"count", frames},          {"mode", "ATTRIBUTES"},
            {"filter", "QUATERNION"}};
    all.append(bytes.begin(), bytes.end());
  }
  small["buffers"].push_back(
      {{"byteLength", all.size()},
       {"uri", "data:application/octet-stream;base64," + mien::test::base64(all)}});
  const Recording read = parse_gltf(small.dump(), "small.gltf");
  ASSERT_EQ(read.frame_count(), recording.frame_count());
  EXPECT_LT(mien::test::largest_turn(recording, read), 3e-4);
  EXPECT_GT(mien::test::largest_turn(recording, read), 1e-9) << "nothing was filtered";
}

TEST(GltfPackedByMeshopt, IsRefusedInPlainWordsWhenItIsFaulty) {
  const json good = packed(to_glb(random_figure(1)), "EXT_meshopt_compression");
  struct Case {
    const char* key;
    json value;
    const char* words;
  };
  for (const Case& bad : std::vector<Case>{{"mode", "MAGIC", "mode MAGIC is not known"},
                                           {"byteStride", 3, "byteStride 3 does not fit its mode"},
                                           {"byteStride", 0, "byteStride 0 does not fit its mode"},
                                           {"byteStride", 512, "byteStride 512"},
                                           {"count", 1u << 30, "too many elements"},
                                           {"count", -4, "count is no number"},
                                           {"count", 900, "damaged or from a newer version"},
                                           {"buffer", 7, "there is no such buffer"},
                                           {"byteLength", 99999999, "reaches beyond its buffer"},
                                           {"byteLength", 3, "damaged"},
                                           {"filter", "QUATERNION", "filter QUATERNION"},
                                           {"filter", "BLUR", "filter BLUR"}}) {
    json broken = good;
    broken["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][bad.key] = bad.value;
    const std::string said = mien::test::refusal_of([&] { parse_gltf(broken.dump(), "f.gltf"); });
    EXPECT_TRUE(said.starts_with("f.gltf: buffer view 0, compressed by meshopt:")) << said;
    EXPECT_NE(said.find(bad.words), std::string::npos) << said << "\nlacks: " << bad.words;
    EXPECT_NE(said.find("; unpack it"), std::string::npos) << "no remedy: " << said;
  }
}

TEST(GltfPackedByMeshopt, DamagedAnyhowIsTakenOrRefused) {
  const json good = packed(to_glb(random_figure(2)), "EXT_meshopt_compression");
  const std::string text = good.dump();
  const size_t begin = text.find("base64,") + 7;
  const size_t end = text.find('"', begin);
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    std::string damaged = text;
    damaged[begin + random() % (end - begin - 4)] = "ABCDwxyz0189+/"[random() % 14];
    try {
      parse_gltf(damaged, "f.gltf");
    } catch (const Error&) {
    }
  }
}

TEST(Gltf, ReadsPlainIntegersAsTheyAre) {
  mien::test::GltfNumbers numbers;
  const int times = numbers.add({0, 1}, "SCALAR");
  const int places =
      numbers.add(std::vector<std::int16_t>{0, 0, 0, -3, 500, 7}, "VEC3", 5122, false);
  const std::string text = mien::test::gltf_text(numbers, R"("nodes":[{}])",
                                                 mien::test::gltf_channel(0, 0, "translation"),
                                                 mien::test::gltf_sampler(times, places, "LINEAR"));
  const Recording recording = parse_gltf(text, "f.gltf");
  EXPECT_EQ(recording.poses.back().root_position, Vec3(-3, 500, 7));
}

}  // namespace
}  // namespace mien::motion
