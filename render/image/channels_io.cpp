#include <memory>

#include "render/error.h"
#include "render/image/channels.h"
#include "render/image_files/image_files.h"
#include "render/image_files/picture_limits.h"

namespace mien::render {

Channels read_channels(const std::filesystem::path& path) {
  std::string error;
  const std::unique_ptr<ImageFile> file = image_files().open(path.string(), error);
  if (!file) throw Error(path.string() + ": " + error);
  const ImageLayout& layout = file->layout();
  require_readable_size(path.string(), layout.width, layout.height, layout.channels.size());
  Channels channels{.width = layout.width, .height = layout.height, .names = layout.channels};
  channels.values.resize(static_cast<std::size_t>(layout.width) *
                         static_cast<std::size_t>(layout.height) * layout.channels.size());
  if (!file->read(ChannelKind::single, channels.values.data()))
    throw Error(path.string() + ": " + file->error());
  return channels;
}

}  // namespace mien::render
