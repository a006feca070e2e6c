#include "model/background_job.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <fstream>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

#include "vector_registers.h"

namespace ravnoves {
namespace {

class BackgroundJobTest : public ::testing::Test {
  protected:
    void waitForEnd() {
        while (job.isRunning()) {
            ASSERT_TRUE(running.wait(20000));
        }
    }
    /// Works until it is stopped.
    static std::function<void()> endless(const BackgroundJob::Progress& progress) {
        while (progress(0.5)) {
            QThread::msleep(1);
        }
        return {};
    }

    BackgroundJob job;
    QSignalSpy running{&job, &BackgroundJob::runningChanged};
    QSignalSpy finished{&job, &BackgroundJob::finished};
    QSignalSpy failed{&job, &BackgroundJob::failed};
    int result = 0;
};

TEST_F(BackgroundJobTest, TheLatestStartWins) {
    job.start(endless);
    for (int i = 1; i <= 5; ++i) {
        job.start([this, i](const BackgroundJob::Progress&) { return [this, i] { result = i; }; });
    }
    waitForEnd();
    EXPECT_EQ(result, 5);
    EXPECT_EQ(finished.size(), 1);
    EXPECT_EQ(running.size(), 2);
}

TEST_F(BackgroundJobTest, WhatIsStoppedHasEnded) {
    std::atomic<bool> begun = false;
    std::atomic<bool> ended = false;
    job.start([&](const BackgroundJob::Progress& progress) {
        begun = true;
        endless(progress);
        QThread::msleep(20);
        ended = true;
        return std::function<void()>();
    });
    while (!begun) {
        QThread::msleep(1);
    }
    job.stop();
    EXPECT_TRUE(ended);
    EXPECT_FALSE(job.isRunning());
    QTest::qWait(30);
    EXPECT_EQ(finished.size(), 0);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(BackgroundJobTest, WithoutAThreadTheWorkIsDoneAllTheSame) {
    // No room for another stack, and those that the library keeps are in use.
    std::atomic<bool> done = false;
    std::vector<std::thread> others;
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ASSERT_GT(pages, 0);
    constexpr rlim_t slack = 4U << 20U;
    rlimit tight = before;
    tight.rlim_cur =
        static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + slack;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
    bool isFull = false;
    try {
        while (others.size() < 100) {
            others.emplace_back([&] {
                while (!done) {
                    QThread::msleep(1);
                }
            });
        }
    } catch (const std::system_error&) {
        isFull = true;
    }
    job.start([this](const BackgroundJob::Progress&) { return [this] { result = 7; }; });
    setrlimit(RLIMIT_AS, &before);
    done = true;
    for (std::thread& other : others) {
        other.join();
    }
    EXPECT_TRUE(isFull);
    waitForEnd();
    EXPECT_EQ(result, 7);
}
#endif

TEST_F(BackgroundJobTest, WhatIsCancelledDeliversNothing) {
    job.start([this](const BackgroundJob::Progress& progress) {
        endless(progress);
        return [this] { result = 1; };
    });
    job.cancel();
    EXPECT_FALSE(job.isRunning());
    job.start([this](const BackgroundJob::Progress&) { return [this] { result += 2; }; });
    waitForEnd();
    EXPECT_EQ(result, 2);
}

TEST_F(BackgroundJobTest, ShortRunsOfADragComeToTheirEnd) {
    job.setPatience(10000, 1);
    std::atomic<bool> go = false;
    job.start([&](const BackgroundJob::Progress& progress) {
        while (!go && progress(0.0)) {
            QThread::msleep(1);
        }
        return [this] { result = 10 * result + 1; };
    });
    QTest::qWait(50);  // it runs
    for (int i = 2; i <= 4; ++i) {
        job.start([this, i](const BackgroundJob::Progress&) {
            return [this, i] { result = 10 * result + i; };
        });
    }
    go = true;
    waitForEnd();
    EXPECT_EQ(result, 14);
    job.setPatience(0, 1);
    job.start(endless);
    QTest::qWait(50);
    job.start([this](const BackgroundJob::Progress&) { return [this] { result = 5; }; });
    waitForEnd();
    EXPECT_EQ(result, 5);
}

TEST_F(BackgroundJobTest, WhatWaitsForRestRunsWhenTheHandRests) {
    job.setPatience(10000, 200, true);
    QElapsedTimer sinceStart;
    for (int i = 1; i <= 30; ++i) {  // half as long again as the pause
        sinceStart.start();
        job.start([this, i](const BackgroundJob::Progress&) { return [this, i] { result = i; }; });
        QTest::qWait(10);
        if (sinceStart.elapsed() < 150) {  // the machine may be busy
            EXPECT_EQ(result, 0);
        }
    }
    waitForEnd();
    EXPECT_EQ(result, 30);
    EXPECT_TRUE(sinceStart.elapsed() >= 190) << sinceStart.elapsed();
}

/// Neither what made the worker's thread nor the job before leaves it with vector registers in use,
/// which would make sines and the like eight times slower.
TEST_F(BackgroundJobTest, BeginsWithClearVectorRegisters) {
    test::dirty_vector_registers();
    EXPECT_EQ(test::are_vector_registers_dirty(), test::has_wide_vectors());
    for (int i = 0; i < 3; ++i) {
        bool dirty = true;
        test::dirty_vector_registers();
        job.start([&](const BackgroundJob::Progress&) {
            dirty = test::are_vector_registers_dirty();
            test::dirty_vector_registers();
            return [this] { ++result; };
        });
        waitForEnd();
        EXPECT_FALSE(dirty) << i;
    }
    EXPECT_EQ(result, 3);
}

TEST_F(BackgroundJobTest, EveryExceptionComesOutAsAMessage) {
    const auto fails = [&](auto thrown) {
        failed.clear();
        job.start(
            [thrown](const BackgroundJob::Progress&) -> std::function<void()> { throw thrown; });
        waitForEnd();
        EXPECT_EQ(failed.size(), 1);
        return failed.isEmpty() ? QString() : failed.first().at(0).toString();
    };
    EXPECT_EQ(fails(std::runtime_error("too steep")), QStringLiteral("too steep"));
    EXPECT_EQ(fails(std::bad_alloc()), QStringLiteral("There is not enough memory for this."));
    EXPECT_EQ(fails(7), QStringLiteral("The computation failed."));
    EXPECT_EQ(finished.size(), 3);
    EXPECT_FALSE(job.isRunning());
}

}  // namespace
}  // namespace ravnoves
