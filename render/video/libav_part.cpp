// The part of the program that is linked to FFmpeg's libraries (libav_calls.cpp): with it come all
// their functions.

#include "render/video/libav.h"

extern "C" {
/// One function of each, so that each is linked.
extern decltype(&avcodec_version) const mien_video_libraries[];
decltype(&avcodec_version) const mien_video_libraries[] = {avcodec_version, avformat_version,
                                                           avutil_version, swscale_version};
}
