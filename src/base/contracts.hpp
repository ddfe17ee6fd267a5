#pragma once

#include <cstdio>
#include <cstdlib>

/// A condition that only a mistake of ours can break. On in the dev and audit builds, free in
/// release.
#ifdef TT_CONTRACTS
#define TT_EXPECTS(condition)                                                                     \
    do {                                                                                          \
        if (!(condition)) {                                                                       \
            std::fprintf(stderr, "%s:%d: contract broken: %s\n", __FILE__, __LINE__, #condition); \
            std::abort();                                                                         \
        }                                                                                         \
    } while (false)
#else
#define TT_EXPECTS(condition) static_cast<void>(0)
#endif
