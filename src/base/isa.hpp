#pragma once

/// TT_CLONES before a function compiles it for AVX-512, AVX2 and the baseline and picks one when
/// the program starts, so that one installed binary is fast on a new CPU and right on an old one.
/// Everything the function calls in its loops must be TT_INLINE to be compiled along.
/// Floating-point contraction is off for the whole project, so the three versions give the same
/// bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(TT_NO_CLONES)
#define TT_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define TT_CLONES
#endif

#define TT_INLINE inline __attribute__((always_inline))
/// The same after the parameters of a lambda.
#define TT_INLINE_LAMBDA __attribute__((always_inline))
