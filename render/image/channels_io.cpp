#include <memory>

#include <OpenImageIO/imageio.h>

#include "render/error.h"
#include "render/image/channels.h"

namespace mien::render {

Channels read_channels(const std::filesystem::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
  if (!input) throw Error(path.string() + ": " + OIIO::geterror());
  input->threads(1);
  const OIIO::ImageSpec& spec = input->spec();
  Channels channels{.width = spec.width, .height = spec.height, .names = spec.channelnames};
  channels.values.resize(static_cast<std::size_t>(spec.image_pixels()) *
                         static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, channels.values.data()))
    throw Error(path.string() + ": " + input->geterror());
  return channels;
}

}  // namespace mien::render
