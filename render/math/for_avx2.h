#pragma once

/// Function attribute: compiles the function for AVX2 as well; the version is selected when the
/// program starts. Both give bit-identical results, because AVX2 alone has no fused multiply-add.
/// Disabled under the thread sanitizer, which is not initialised yet at that time, and for clang,
/// which does not inline functions with vectors into both versions.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__clang__)
#define MIEN_FOR_AVX2_TOO __attribute__((target_clones("avx2", "default")))
#else
#define MIEN_FOR_AVX2_TOO
#endif
