#pragma once

/// Before a function: compiles it for AVX2 as well, and the program chooses when it starts. Both
/// give the same bits: AVX2 alone has no fused multiply-add. Not with the thread sanitizer, which
/// is not ready yet when the choice is made.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_THREAD__)
#define MIEN_FOR_AVX2_TOO __attribute__((target_clones("avx2", "default")))
#else
#define MIEN_FOR_AVX2_TOO
#endif
