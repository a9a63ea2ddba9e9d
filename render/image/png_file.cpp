#include "render/image/png_file.h"

#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <system_error>

#include <png.h>

#include "render/error.h"

namespace mien::render {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenedFile = std::unique_ptr<std::FILE, CloseFile>;

// libpng reports errors by longjmp. The functions that call it return false then, and have no local
// objects that would have to be destroyed.

[[noreturn]] void note_png_error(png_structp png, png_const_charp what) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = what;
  png_longjmp(png, 1);
}

void ignore_png_warning(png_structp, png_const_charp) {}

/// Words as files have them.
void use_own_order(png_structp png, int bits) {
  if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
}

/// What OpenImageIO says of a picture's colours and place.
void describe(png_structp png, png_infop info) {
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
  png_set_oFFs(png, info, 0, 0, PNG_OFFSET_PIXEL);
  char key[] = "oiio:ColorSpace", value[] = "sRGB";
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = key;
  text.text = value;
  png_set_text(png, info, &text, 1);
}

/// Rendered gradients gain little from more effort, and a frame is written many times as fast. Of
/// 8 bits there are few codes, each often repeated: unfiltered rows are smaller, and written three
/// times as fast.
void set_effort(png_structp png, int bits) {
  png_set_compression_level(png, bits == 8 ? 2 : 3);
  if (bits == 8) png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
}

bool write_all(png_structp png, png_infop info, std::FILE* file, const PngPixels& pixels) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_init_io(png, file);
  set_effort(png, pixels.bits);
  png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width),
               static_cast<png_uint_32>(pixels.height), pixels.bits, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  describe(png, info);
  png_write_info(png, info);
  use_own_order(png, pixels.bits);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  const auto* rows = static_cast<const std::uint8_t*>(pixels.values);
  for (int y = 0; y < pixels.height; ++y)
    png_write_row(png, rows + static_cast<std::size_t>(y) * row_bytes);
  png_write_end(png, nullptr);
  return true;
}

struct PngWriting {
  std::string error;
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, note_png_error, ignore_png_warning);
  png_infop info = png_create_info_struct(png);

  PngWriting() = default;
  PngWriting(const PngWriting&) = delete;
  PngWriting& operator=(const PngWriting&) = delete;
  ~PngWriting() { png_destroy_write_struct(&png, &info); }
};

bool read_head(png_structp png, png_infop info, std::FILE* file) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_init_io(png, file);
  png_read_info(png, info);
  use_own_order(png, png_get_bit_depth(png, info));
  return true;
}

bool read_rows(png_structp png, png_infop info, std::uint8_t* values) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  const png_uint_32 height = png_get_image_height(png, info);
  for (int pass = 0; pass < passes; ++pass)
    for (png_uint_32 y = 0; y < height; ++y) png_read_row(png, values + y * row_bytes, nullptr);
  png_read_end(png, nullptr);
  return true;
}

/// With the system's own reason, which libpng does not pass on.
Error unwritable(const std::filesystem::path& path, int error) {
  return Error(path.string() + ": cannot be written (" + std::generic_category().message(error) +
               ")");
}

}  // namespace

void write_png_file(const std::filesystem::path& path, const PngPixels& pixels) {
  OpenedFile file(std::fopen(path.c_str(), "wb"));
  if (!file) throw unwritable(path, errno);
  const PngWriting writing;
  errno = 0;
  if (!write_all(writing.png, writing.info, file.get(), pixels))
    throw errno != 0 ? unwritable(path, errno)
                     : Error(path.string() + ": writing: " + writing.error);
  if (std::fclose(file.release()) != 0) throw unwritable(path, errno);
}

struct PngFile::State {
  std::string name;
  std::FILE* file;
  std::string error;
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, note_png_error, ignore_png_warning);
  png_infop info = png_create_info_struct(png);

  explicit State(const std::filesystem::path& path)
      : name(path.string()), file(std::fopen(path.c_str(), "rb")) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    png_destroy_read_struct(&png, &info, nullptr);
    if (file) std::fclose(file);
  }
};

PngFile::PngFile(const std::filesystem::path& path) : state_(std::make_unique<State>(path)) {
  if (!state_->file) throw Error(state_->name + ": cannot be opened");
  if (!read_head(state_->png, state_->info, state_->file))
    throw Error(state_->name + ": is not png: " + state_->error);
}

PngFile::~PngFile() = default;

int PngFile::width() const {
  return static_cast<int>(png_get_image_width(state_->png, state_->info));
}

int PngFile::height() const {
  return static_cast<int>(png_get_image_height(state_->png, state_->info));
}

int PngFile::channels() const { return png_get_channels(state_->png, state_->info); }

int PngFile::bits() const { return png_get_bit_depth(state_->png, state_->info); }

void PngFile::read(void* values) {
  if (!read_rows(state_->png, state_->info, static_cast<std::uint8_t*>(values)))
    throw Error(state_->name + ": decoding: " + state_->error);
}

std::string png_library() { return png_get_libpng_ver(nullptr); }

}  // namespace mien::render
