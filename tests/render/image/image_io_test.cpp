#include "render/image/image_io.h"

#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/image/channels.h"
#include "render/image_files/picture_limits.h"
#include "render/refusal.h"

namespace mien::render {
namespace {

using test::bytes_of;
using test::refusal_of;

constexpr int wide = 67, high = 41;

template <class Channel>
Image<Channel> noise() {
  Image<Channel> image(wide, high);
  std::mt19937 random(5);
  for (Channel& channel : image.channels) channel = static_cast<Channel>(random());
  return image;
}

Framebuffer light() {
  Framebuffer framebuffer(wide, high);
  std::mt19937 random(6);
  std::uniform_real_distribution<float> stops(-12.0f, 12.0f);
  for (float& channel : framebuffer.channels) channel = std::exp2(stops(random));
  return framebuffer;
}

class ImageIo : public testing::Test {
 protected:
  mien::test::TemporaryFolder temporary;
  const std::filesystem::path png = temporary.path() / "picture.png";
  const std::filesystem::path exr = temporary.path() / "picture.exr";
};

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255u);
  return bytes;
}

std::string png_chunk(const std::string& kind_and_content) {
  std::uint32_t sum = ~0u;
  for (const char one : kind_and_content) {
    sum ^= static_cast<unsigned char>(one);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ (0xEDB88320u & (0u - (sum & 1u)));
  }
  return big_endian(static_cast<std::uint32_t>(kind_and_content.size() - 4)) + kind_and_content +
         big_endian(~sum);
}

/// A file of a few bytes that says to be a picture of that size.
std::string png_of_size(std::uint32_t width, std::uint32_t height) {
  using namespace std::string_literals;
  return "\x89PNG\r\n\x1a\n"s +
         png_chunk("IHDR" + big_endian(width) + big_endian(height) + "\x08\x02\0\0\0"s) +
         png_chunk("IDAT\x78\x9c"s) + png_chunk("IEND");
}

TEST_F(ImageIo, TakesNoMemoryForAPictureThatIsLargerThanAreRead) {
  const auto write = [&](std::uint32_t width, std::uint32_t height) {
    std::ofstream(png, std::ios::binary) << png_of_size(width, height);
  };
  write(60'000, 60'000);  // 43 GB as it would be worked with
  for (const std::string& refusal :
       {refusal_of([&] { read_png8(png); }), refusal_of([&] { check_image(png); }),
        refusal_of([&] { read_channels(png); })})
    EXPECT_EQ(refusal, png.string() +
                           ": has 60000 x 60000 pixels, more than the limit of 8192 x 8192 or "
                           "the same number in another shape");
  write(16, 16);  // whose pixels are missing
  EXPECT_NE(refusal_of([&] { read_png8(png); }).find("decoding"), std::string::npos);
}

TEST(PictureLimits, CountValuesWithoutOverflow) {
  EXPECT_EQ(picture_read_error(8192, 8192, 4), "");
  EXPECT_EQ(picture_read_error(1 << 28, 1, 1), "");
  EXPECT_NE(picture_read_error(8192, 8193, 4), "");
  EXPECT_NE(picture_read_error(std::int64_t{1} << 32, std::int64_t{1} << 32, 1), "");
  EXPECT_NE(picture_read_error(std::int64_t{1} << 62, 4, 4), "");
  EXPECT_NE(picture_read_error(0, 8, 3), "");
  EXPECT_NE(picture_read_error(-8, 8, 3), "");
}

TEST_F(ImageIo, KeepsEveryBitOfAPng) {
  write_png(png, noise<std::uint8_t>());
  EXPECT_EQ(read_png8(png), noise<std::uint8_t>());
  write_png(png, noise<std::uint16_t>());
  EXPECT_EQ(read_png16(png), noise<std::uint16_t>());
}

/// We write PNGs with libpng; OpenImageIO reads them as shares of full scale.
template <class Channel>
void expect_read_alike(const std::filesystem::path& file, const Image<Channel>& image) {
  const Channels read = read_channels(file);
  ASSERT_EQ(read.values.size(), image.channels.size());
  for (std::size_t i = 0; i < read.values.size(); ++i)
    EXPECT_NEAR(read.values[i] * std::numeric_limits<Channel>::max(), image.channels[i], 0.01f);
}

TEST_F(ImageIo, WritesPngsThatOthersReadAlike) {
  write_png(png, noise<std::uint8_t>());
  expect_read_alike(png, noise<std::uint8_t>());
  write_png(png, noise<std::uint16_t>());
  expect_read_alike(png, noise<std::uint16_t>());
}

TEST_F(ImageIo, KeepsEveryBitOfAFloatExr) {
  write_exr(exr, light(), ExrDepth::Float);
  EXPECT_EQ(read_exr(exr), light());
}

TEST_F(ImageIo, KeepsElevenBitsOfAHalfExr) {
  write_exr(exr, light(), ExrDepth::Half);
  const Framebuffer before = light(), after = read_exr(exr);
  ASSERT_EQ(after.channels.size(), before.channels.size());
  for (std::size_t i = 0; i < before.channels.size(); ++i)
    EXPECT_NEAR(after.channels[i], before.channels[i], 0x1p-11f * before.channels[i]);
}

TEST_F(ImageIo, WritesTheSameBytesForTheSamePictureAtAnotherTime) {
  const auto write = [&](const std::string& name) {
    const auto png_path = temporary.path() / (name + ".png");
    const auto exr_path = temporary.path() / (name + ".exr");
    write_png(png_path, noise<std::uint8_t>());
    write_exr(exr_path, light());
    return std::array{bytes_of(png_path), bytes_of(exr_path)};
  };
  const auto first = write("first");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // files count in seconds
  EXPECT_EQ(first, write("second"));
}

TEST_F(ImageIo, TellsWhatAFileHolds) {
  write_png(png, noise<std::uint16_t>());
  const ImageSummary of_png = check_image(png);
  EXPECT_EQ(of_png.format, "png");
  EXPECT_EQ(of_png.width, wide);
  EXPECT_EQ(of_png.height, high);
  EXPECT_EQ(of_png.channels, 3);
  EXPECT_EQ(of_png.bits, 16);
  EXPECT_EQ(of_png.color_space, "sRGB");
  write_exr(exr, light());
  const ImageSummary of_exr = check_image(exr);
  EXPECT_EQ(of_exr.format, "openexr");
  EXPECT_EQ(of_exr.bits, 16);
  EXPECT_EQ(of_exr.color_space.substr(0, 6), "Linear");
}

/// OpenImageIO 2.4 loses its error message when libpng jumps out of its reading of a short file.
/// Leaks within this scope are not reported.
class LeakOfOpenImageIo {
 public:
#ifdef __SANITIZE_ADDRESS__
  LeakOfOpenImageIo() { __lsan_disable(); }
  ~LeakOfOpenImageIo() { __lsan_enable(); }
#else
  LeakOfOpenImageIo() {}
#endif
  LeakOfOpenImageIo(const LeakOfOpenImageIo&) = delete;
  LeakOfOpenImageIo& operator=(const LeakOfOpenImageIo&) = delete;
};

TEST_F(ImageIo, RefusesAPngThatIsCutShort) {
  const LeakOfOpenImageIo not_ours;
  for (const double share : {0.98, 0.5, 0.1, 0.0}) {
    write_png(png, noise<std::uint8_t>());
    test::cut_short(png, share);
    EXPECT_NE(refusal_of([&] { read_png8(png); }).find("picture.png: "), std::string::npos);
    EXPECT_NE(refusal_of([&] { check_image(png); }), "");
  }
}

TEST_F(ImageIo, RefusesAnExrThatIsCutShort) {
  for (const double share : {0.98, 0.5, 0.1, 0.0}) {
    write_exr(exr, light());
    test::cut_short(exr, share);
    EXPECT_NE(refusal_of([&] { read_exr(exr); }).find("picture.exr: "), std::string::npos);
    EXPECT_NE(refusal_of([&] { check_image(exr); }), "");
  }
}

TEST_F(ImageIo, RefusesAPngWithAFlippedBit) {
  write_png(png, noise<std::uint8_t>());
  const std::vector<char> sound = bytes_of(png);
  for (const double where : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    std::vector<char> damaged = sound;
    damaged[static_cast<std::size_t>(where * static_cast<double>(sound.size()))] ^= 0x10;
    test::replace_bytes(png, damaged);
    EXPECT_NE(refusal_of([&] { read_png8(png); }), "") << "at " << where;
    EXPECT_NE(refusal_of([&] { check_image(png); }), "") << "at " << where;
  }
}

TEST_F(ImageIo, RefusesAnotherFormatOrDepthThanAskedFor) {
  write_png(png, noise<std::uint16_t>());
  EXPECT_NE(refusal_of([&] { read_png8(png); }).find("bits per channel"), std::string::npos);
  EXPECT_NE(refusal_of([&] { read_exr(png); }).find("is not openexr"), std::string::npos);
}

TEST_F(ImageIo, RefusesAFolderThatIsNotThere) {
  const auto nowhere = temporary.path() / "no" / "picture.png";
  EXPECT_NE(refusal_of([&] { write_png(nowhere, noise<std::uint8_t>()); }).find("picture.png"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { read_png8(nowhere); }).find("picture.png"), std::string::npos);
}

}  // namespace
}  // namespace mien::render
