#include "theme/one_painter.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSemaphore>
#include <QThread>
#include <QThreadPool>

namespace ravnoves {
namespace {

qsizetype threads() {
    return QDir(QStringLiteral("/proc/self/task"))
        .entryList(QDir::Dirs | QDir::NoDotAndDotDot)
        .size();
}

TEST(OnePainter, WhatIsTranslucentIsPaintedInOneThread) {
    paintInOneThread();
    const qsizetype before = threads();
    QImage picture(400, 400, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 128));
    painter.drawEllipse(picture.rect());
    painter.end();
    EXPECT_EQ(qGray(picture.pixel(200, 200)), 127);
    EXPECT_EQ(threads(), before);
}

TEST(OnePainter, OtherPoolsHaveThreads) {
    QThreadPool pool;
    QSemaphore done;
    QThread* ran = nullptr;
    pool.start([&] {
        ran = QThread::currentThread();
        done.release();
    });
    done.acquire();
    EXPECT_NE(ran, QThread::currentThread());
    pool.waitForDone();
}

}  // namespace
}  // namespace ravnoves
