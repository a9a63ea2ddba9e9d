// The part of the program that is linked to OpenImageIO (image_files.h).

#include "render/image_files/image_files.h"

#include <cstddef>
#include <iterator>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

namespace mien::render {

namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

TypeDesc type_of(ChannelKind kind) {
  constexpr TypeDesc::BASETYPE types[] = {TypeDesc::UINT8, TypeDesc::UINT16, TypeDesc::HALF,
                                          TypeDesc::FLOAT, TypeDesc::UNKNOWN};
  static_assert(std::size(types) == static_cast<std::size_t>(ChannelKind::other) + 1);
  return types[static_cast<std::size_t>(kind)];
}

ChannelKind kind_of(TypeDesc type) {
  for (const ChannelKind kind :
       {ChannelKind::byte, ChannelKind::word, ChannelKind::half, ChannelKind::single}) {
    if (type == type_of(kind)) return kind;
  }
  return ChannelKind::other;
}

ImageLayout layout_of(const ImageInput& input) {
  const ImageSpec& spec = input.spec();
  return {.width = spec.width,
          .height = spec.height,
          .channels = spec.channelnames,
          .stored = kind_of(spec.format),
          .bits = static_cast<int>(8 * spec.format.size()),
          .format = input.format_name(),
          .color_space = std::string(spec.get_string_attribute("oiio:ColorSpace"))};
}

class OpenFile final : public ImageFile {
 public:
  using Memory = std::unique_ptr<OIIO::Filesystem::IOMemReader>;

  OpenFile(std::unique_ptr<ImageInput> input, Memory memory)
      : memory_(std::move(memory)), input_(std::move(input)) {
    input_->threads(1);
    layout_ = layout_of(*input_);
  }

  const ImageLayout& layout() const override { return layout_; }

  bool select(int picture) override {
    if (!input_->seek_subimage(picture, 0)) return false;
    picture_ = picture;
    layout_ = layout_of(*input_);
    return true;
  }

  bool read(ChannelKind wanted, void* values) override {
    const auto count = static_cast<int>(layout_.channels.size());
    return input_->read_image(picture_, 0, 0, count, type_of(wanted), values);
  }

  std::string error() const override { return input_->geterror(); }

 private:
  Memory memory_;  // outlives what reads it
  std::unique_ptr<ImageInput> input_;
  ImageLayout layout_;
  int picture_ = 0;
};

ImageSpec spec_of(const ImagePart& part) {
  ImageSpec spec(part.width, part.height, part.count, type_of(part.stored));
  if (!part.channels.empty()) spec.channelnames = part.channels;
  for (const auto& [name, value] : part.attributes) {
    if (const int* number = std::get_if<int>(&value)) {
      spec.attribute(name, *number);
    } else {
      spec.attribute(name, std::get<std::string>(value));
    }
  }
  return spec;
}

bool write_parts(ImageOutput& output, const std::string& path,
                 const std::vector<ImagePart>& parts) {
  std::vector<ImageSpec> specs;
  for (const ImagePart& part : parts) specs.push_back(spec_of(part));
  const bool is_one = specs.size() == 1;
  if (is_one ? !output.open(path, specs[0])
             : !output.open(path, static_cast<int>(specs.size()), specs.data()))
    return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0 && !output.open(path, specs[i], ImageOutput::AppendSubimage)) return false;
    if (!output.write_image(type_of(parts[i].given), parts[i].values)) return false;
  }
  return output.close();
}

OIIO::ImageBuf buffer_of(const ImageValues& image) {
  // It takes what it only reads as something that it may write.
  return OIIO::ImageBuf(ImageSpec(image.width, image.height, 3, type_of(image.kind)),
                        const_cast<void*>(image.values));
}

class OpenImageIoFiles final : public ImageFiles {
 public:
  std::unique_ptr<ImageFile> open(const std::string& path, std::string& error) const override {
    std::unique_ptr<ImageInput> input = ImageInput::open(path);
    if (input) return std::make_unique<OpenFile>(std::move(input), nullptr);
    error = OIIO::geterror();
    return nullptr;
  }

  std::unique_ptr<ImageFile> open(std::span<const unsigned char> bytes, const std::string& name,
                                  std::string& error) const override {
    auto memory = std::make_unique<OIIO::Filesystem::IOMemReader>(
        const_cast<unsigned char*>(bytes.data()), bytes.size());
    std::unique_ptr<ImageInput> input = ImageInput::open(name, nullptr, memory.get());
    if (input) return std::make_unique<OpenFile>(std::move(input), std::move(memory));
    error = OIIO::geterror();
    return nullptr;
  }

  bool write(const std::string& path, const std::vector<ImagePart>& parts,
             std::string& error) const override {
    const std::unique_ptr<ImageOutput> output = ImageOutput::create(path);
    if (!output) {
      error = OIIO::geterror();
      return false;
    }
    output->threads(1);
    if (write_parts(*output, path, parts)) return true;
    error = output->geterror();
    return false;
  }

  bool encode(const std::string& name, const ImagePart& part, std::string& bytes,
              std::string& error) const override {
    OIIO::Filesystem::IOVecOutput memory;
    const std::unique_ptr<ImageOutput> output = ImageOutput::create(name, &memory);
    if (!output) {
      error = OIIO::geterror();
      return false;
    }
    output->threads(1);
    output->set_ioproxy(&memory);
    if (!write_parts(*output, name, {part})) {
      error = output->geterror();
      return false;
    }
    bytes.assign(memory.buffer().begin(), memory.buffer().end());
    return true;
  }

  ImageComparison compare(const ImageValues& a, const ImageValues& b,
                          float threshold) const override {
    const auto found = OIIO::ImageBufAlgo::compare(buffer_of(a), buffer_of(b), threshold, threshold,
                                                   OIIO::ROI(), 1);
    return {.mean = found.meanerror,
            .rms = found.rms_error,
            .psnr_db = found.PSNR,
            .largest = found.maxerror,
            .x = found.maxx,
            .y = found.maxy,
            .channel = found.maxc,
            .failing = static_cast<std::int64_t>(found.nfail)};
  }

  std::string version() const override {
    const int version = OIIO::openimageio_version();
    return std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
           std::to_string(version % 100);
  }
};

}  // namespace

extern "C" const void* mien_part(int edition) {
  static const OpenImageIoFiles files;
  return edition == image_files_edition ? &files : nullptr;
}

}  // namespace mien::render
