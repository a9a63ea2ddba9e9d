#include "motion/points/marker_names.h"

namespace mien::motion {

namespace {

using enum Landmark;

constexpr MarkerName abbreviations[] = {
    {"*HJC", hip},
    {"*KJC", knee},
    {"*AJC", ankle},
    {"*SJC", shoulder},
    {"*EJC", elbow},
    {"*WJC", wrist},
    {"*LFC", outer_knee},  // lateral and medial condyle of the femur
    {"*MFC", inner_knee},
    {"*LKNE", outer_knee},
    {"*MKNE", inner_knee},
    {"*KNM", inner_knee},
    {"*KNEM", inner_knee},
    {"*LMAL", outer_ankle},
    {"*MMAL", inner_ankle},
    {"*MANK", inner_ankle},
    {"*ANKM", inner_ankle},
    {"*MELB", inner_elbow},
    {"*ELBM", inner_elbow},
    {"*CAL", heel},
    {"*MT1", first_metatarsal},
    {"*MT2", second_metatarsal},
    {"*MT5", fifth_metatarsal},
    {"*D1M", first_metatarsal},
    {"*D5M", fifth_metatarsal},
    {"*TH1", thigh},
    {"*TH2", thigh},
    {"*TH3", thigh},
    {"*TH4", thigh},
    {"*THAP", thigh},
    {"*THAD", thigh},
    {"*THI", thigh},
    {"*TB1", shank},
    {"*TB2", shank},
    {"*TB3", shank},
    {"*TB4", shank},
    {"*TIB", shank},
    {"*TIAP", shank},
    {"*TIAD", shank},
    {"*ICR", iliac_crest},
    {"*ILC", iliac_crest},
    {"*GTR", trochanter},
};

}  // namespace

std::span<const MarkerName> marker_abbreviations() { return abbreviations; }

}  // namespace mien::motion
