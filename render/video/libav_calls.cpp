// FFmpeg's libraries take 0.02 s to load, more than all else that mien is linked to. So mien is not
// linked to them: here are those of their functions that it calls, and the part that is linked is
// libav_part.cpp.

extern "C" {
#include <libavutil/mem.h>
#include <libavutil/sha.h>
}

#include "render/parts/library_calls.h"
#include "render/video/libav.h"

namespace mien::render {

namespace {

struct VideoFiles {
  static const char* name() { return "mien-video-files.so"; }
  static const char* purpose() { return "reads and writes videos"; }
};

}  // namespace

}  // namespace mien::render

#define MIEN_LIBAV(result, name, parameters, arguments) \
  MIEN_LIBRARY_CALL(mien::render::VideoFiles, result, name, parameters, arguments)

// clang-format off
extern "C" {
MIEN_LIBAV(const char*, av_color_primaries_name, (AVColorPrimaries a), (a))
MIEN_LIBAV(const char*, av_color_range_name, (AVColorRange a), (a))
MIEN_LIBAV(const char*, av_color_space_name, (AVColorSpace a), (a))
MIEN_LIBAV(const char*, av_color_transfer_name, (AVColorTransferCharacteristic a), (a))
MIEN_LIBAV(void, av_dict_free, (AVDictionary** a), (a))
MIEN_LIBAV(int, av_dict_set, (AVDictionary** a, const char* b, const char* c, int d), (a, b, c, d))
MIEN_LIBAV(int, av_find_best_stream, (AVFormatContext* a, AVMediaType b, int c, int d,
            const AVCodec** e, int f), (a, b, c, d, e, f))
MIEN_LIBAV(AVFrame*, av_frame_alloc, (), ())
MIEN_LIBAV(void, av_frame_free, (AVFrame** a), (a))
MIEN_LIBAV(int, av_frame_get_buffer, (AVFrame* a, int b), (a, b))
MIEN_LIBAV(int, av_frame_make_writable, (AVFrame* a), (a))
MIEN_LIBAV(void, av_frame_unref, (AVFrame* a), (a))
MIEN_LIBAV(void, av_free, (void* a), (a))
MIEN_LIBAV(const char*, av_get_pix_fmt_name, (AVPixelFormat a), (a))
MIEN_LIBAV(int, av_interleaved_write_frame, (AVFormatContext* a, AVPacket* b), (a, b))
MIEN_LIBAV(void, av_log_set_level, (int a), (a))
MIEN_LIBAV(int, av_opt_set, (void* a, const char* b, const char* c, int d), (a, b, c, d))
MIEN_LIBAV(int, av_opt_set_int, (void* a, const char* b, int64_t c, int d), (a, b, c, d))
MIEN_LIBAV(AVPacket*, av_packet_alloc, (), ())
MIEN_LIBAV(void, av_packet_free, (AVPacket** a), (a))
MIEN_LIBAV(void, av_packet_rescale_ts, (AVPacket* a, AVRational b, AVRational c), (a, b, c))
MIEN_LIBAV(void, av_packet_unref, (AVPacket* a), (a))
MIEN_LIBAV(int, av_read_frame, (AVFormatContext* a, AVPacket* b), (a, b))
MIEN_LIBAV(int64_t, av_rescale_q, (int64_t a, AVRational b, AVRational c), (a, b, c))
MIEN_LIBAV(AVSHA*, av_sha_alloc, (), ())
MIEN_LIBAV(void, av_sha_final, (AVSHA* a, uint8_t* b), (a, b))
MIEN_LIBAV(int, av_sha_init, (AVSHA* a, int b), (a, b))
MIEN_LIBAV(void, av_sha_update, (AVSHA* a, const uint8_t* b, size_t c), (a, b, c))
MIEN_LIBAV(int, av_strerror, (int a, char* b, size_t c), (a, b, c))
MIEN_LIBAV(int, av_write_trailer, (AVFormatContext* a), (a))
MIEN_LIBAV(AVCodecContext*, avcodec_alloc_context3, (const AVCodec* a), (a))
MIEN_LIBAV(const AVCodec*, avcodec_find_decoder, (AVCodecID a), (a))
MIEN_LIBAV(const AVCodec*, avcodec_find_encoder_by_name, (const char* a), (a))
MIEN_LIBAV(void, avcodec_flush_buffers, (AVCodecContext* a), (a))
MIEN_LIBAV(void, avcodec_free_context, (AVCodecContext** a), (a))
MIEN_LIBAV(const char*, avcodec_get_name, (AVCodecID a), (a))
MIEN_LIBAV(int, avcodec_open2, (AVCodecContext* a, const AVCodec* b, AVDictionary** c), (a, b, c))
MIEN_LIBAV(int, avcodec_parameters_from_context, (AVCodecParameters* a, const AVCodecContext* b),
           (a, b))
MIEN_LIBAV(int, avcodec_parameters_to_context, (AVCodecContext* a, const AVCodecParameters* b),
           (a, b))
MIEN_LIBAV(int, avcodec_receive_frame, (AVCodecContext* a, AVFrame* b), (a, b))
MIEN_LIBAV(int, avcodec_receive_packet, (AVCodecContext* a, AVPacket* b), (a, b))
MIEN_LIBAV(int, avcodec_send_frame, (AVCodecContext* a, const AVFrame* b), (a, b))
MIEN_LIBAV(int, avcodec_send_packet, (AVCodecContext* a, const AVPacket* b), (a, b))
MIEN_LIBAV(unsigned, avcodec_version, (), ())
MIEN_LIBAV(int, avformat_alloc_output_context2, (AVFormatContext** a, const AVOutputFormat* b,
            const char* c, const char* d), (a, b, c, d))
MIEN_LIBAV(void, avformat_close_input, (AVFormatContext** a), (a))
MIEN_LIBAV(int, avformat_find_stream_info, (AVFormatContext* a, AVDictionary** b), (a, b))
MIEN_LIBAV(void, avformat_free_context, (AVFormatContext* a), (a))
MIEN_LIBAV(AVStream*, avformat_new_stream, (AVFormatContext* a, const AVCodec* b), (a, b))
MIEN_LIBAV(int, avformat_open_input, (AVFormatContext** a, const char* b, const AVInputFormat* c,
            AVDictionary** d), (a, b, c, d))
MIEN_LIBAV(unsigned, avformat_version, (), ())
MIEN_LIBAV(int, avformat_write_header, (AVFormatContext* a, AVDictionary** b), (a, b))
MIEN_LIBAV(int, avio_closep, (AVIOContext** a), (a))
MIEN_LIBAV(int, avio_open, (AVIOContext** a, const char* b, int c), (a, b, c))
MIEN_LIBAV(void, sws_freeContext, (SwsContext* a), (a))
MIEN_LIBAV(const int*, sws_getCoefficients, (int a), (a))
MIEN_LIBAV(SwsContext*, sws_getContext, (int a, int b, AVPixelFormat c, int d, int e,
            AVPixelFormat f, int g, SwsFilter* h, SwsFilter* i, const double* j),
           (a, b, c, d, e, f, g, h, i, j))
MIEN_LIBAV(int, sws_scale, (SwsContext* a, const uint8_t* const* b, const int* c, int d, int e,
            uint8_t* const* f, const int* g), (a, b, c, d, e, f, g))
MIEN_LIBAV(int, sws_setColorspaceDetails, (SwsContext* a, const int* b, int c, const int* d,
            int e, int f, int g, int h), (a, b, c, d, e, f, g, h))
MIEN_LIBAV(unsigned, swscale_version, (), ())
}
// clang-format on

#undef MIEN_LIBAV
