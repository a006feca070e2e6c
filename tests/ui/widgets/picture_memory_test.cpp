#include "theme/picture_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QImage>
#include <QSize>

namespace ravnoves {
namespace {

long pageFaults() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return used.ru_minflt;
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Pictures of a window that is drawn larger step by step, each in place of the last.
TEST(PictureMemory, PicturesFollowOneAnotherInTheSameMemory) {
    keepPictureMemory();
    const auto paintAll = [](QSize size) {
        QImage picture(size, QImage::Format_RGB32);
        picture.fill(Qt::white);
    };
    paintAll({1400, 900});
    const long before = pageFaults();
    constexpr int steps = 100;
    for (int i = 0; i < steps; ++i) {
        paintAll({1280 + i, 800 + i});
    }
    // Of 4 MB each, which are a thousand pages.
    EXPECT_LT(pageFaults() - before, steps);
}
#endif

}  // namespace
}  // namespace ravnoves
