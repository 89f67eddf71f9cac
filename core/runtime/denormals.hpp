#pragma once

#if defined(__SSE__)
#include <immintrin.h>
#endif

namespace echotrail {

/// Makes the calling thread treat numbers below 1e-38 as zero. Particle weights far from the target get that small,
/// and arithmetic on them is a hundred times slower.
inline void flushDenormals() {
#if defined(__SSE__)
    _mm_setcsr(_mm_getcsr() | 0x8040U);  // FTZ and DAZ
#endif
}

}  // namespace echotrail
