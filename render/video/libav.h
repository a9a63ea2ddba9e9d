#pragma once

// The C libraries of FFmpeg, and owning types for their objects. Included by video sources only.

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <string>

#include "render/error.h"

namespace mien::render {

struct FreeCodecContext {
  void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
};
struct FreeFrame {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreePacket {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
struct FreeScaler {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
struct CloseInput {
  void operator()(AVFormatContext* input) const { avformat_close_input(&input); }
};
struct CloseOutput {
  void operator()(AVFormatContext* output) const {
    if (output->pb) avio_closep(&output->pb);
    avformat_free_context(output);
  }
};

using CodecContext = std::unique_ptr<AVCodecContext, FreeCodecContext>;
using Frame = std::unique_ptr<AVFrame, FreeFrame>;
using Packet = std::unique_ptr<AVPacket, FreePacket>;
using Scaler = std::unique_ptr<SwsContext, FreeScaler>;
using Input = std::unique_ptr<AVFormatContext, CloseInput>;
using Output = std::unique_ptr<AVFormatContext, CloseOutput>;

/// Throws Error with the library's error text when `code` is negative; otherwise returns `code`.
inline int checked(int code, const std::string& doing) {
  if (code >= 0) return code;
  char words[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(code, words, sizeof words);
  throw Error(doing + ": " + words);
}

/// Returns a converter between 8-bit sRGB and limited-range BT.709 that rounds identically on every
/// processor.
inline Scaler make_scaler(int width, int height, AVPixelFormat from, AVPixelFormat to,
                          bool to_video) {
  Scaler scaler(sws_getContext(
      width, height, from, width, height, to,
      SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_FULL_CHR_H_INT | SWS_BITEXACT,
      nullptr, nullptr, nullptr));
  if (!scaler) throw Error("video: no conversion between RGB and YUV");
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  constexpr int one = 1 << 16;
  sws_setColorspaceDetails(scaler.get(), bt709, to_video ? 1 : 0, bt709, to_video ? 0 : 1, 0, one,
                           one);
  return scaler;
}

}  // namespace mien::render
