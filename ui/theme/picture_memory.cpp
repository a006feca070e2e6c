#include "theme/picture_memory.h"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ravnoves {

void keepPictureMemory() {
#ifdef __GLIBC__
    constexpr int mib = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 * mib);  // the most that glibc takes
    mallopt(M_TRIM_THRESHOLD, 64 * mib);
#endif
}

}  // namespace ravnoves
