// A long day's work in one window, and what it does to the program's memory:
//   long-use [SHARE]   SHARE of the whole, 0.01…1
// 10⁵ moves of sliders, 10³ cases opened and closed, an hour of animation by a clock that is wound
// by hand. Memory is counted at each fifth of each; where more is in use at the end than after the
// first, beyond what is allowed, the program ends with status 1.

#include <malloc.h>
#include <unistd.h>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QPixmapCache>
#include <QSlider>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <vector>

#include "model/scene_model.h"
#include "page/mechanism_picture.h"
#include "page/scene_page.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "shop/model/journal.h"
#include "text/language.h"
#include "theme/theme.h"
#include "widgets/value_slider.h"

namespace {

using namespace Qt::StringLiterals;
using namespace ravnoves;

constexpr double allowed = 1.0;  ///< MiB in use that a part may add after its first fifth
constexpr double mebibyte = 1024.0 * 1024.0;

/// What the program holds, MiB: blocks in use, and the machine's memory with what lies between
/// them.
struct Memory {
    double used = 0.0;
    double resident = 0.0;
};

Memory memory() {
    // The style keeps a picture of each place of a slider, as many as Qt's limit lets it.
    QPixmapCache::clear();
    malloc_trim(0);
    const auto counted = mallinfo2();
    Memory found{static_cast<double>(counted.uordblks + counted.hblkhd) / mebibyte, 0.0};
    QFile file(u"/proc/self/statm"_s);
    if (file.open(QIODevice::ReadOnly)) {
        found.resident = file.readAll().split(' ').at(1).toDouble() *
                         static_cast<double>(sysconf(_SC_PAGESIZE)) / mebibyte;
    }
    return found;
}

/// Calls `once` so often and says what memory did. @return false where it grew
bool flat(const char* what, int times, const std::function<void(int)>& once) {
    const int fifth = std::max(1, times / 5);
    std::vector<Memory> found;
    QElapsedTimer clock;
    clock.start();
    for (int i = 0; i < times; ++i) {
        if (i > 0 && i % fifth == 0 && i + fifth / 2 < times) {
            found.push_back(memory());
        }
        once(i);
        // As the event loop of a program does, which this one has not.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    found.push_back(memory());
    const bool isFlat = found.back().used - found.front().used <= allowed;
    std::printf("%-34s %7d times %7.1f s   MiB in use", what, times,
                1e-3 * static_cast<double>(clock.elapsed()));
    for (const Memory& each : found) {
        std::printf(" %6.1f", each.used);
    }
    std::printf("   resident");
    for (const Memory& each : found) {
        std::printf(" %6.1f", each.resident);
    }
    std::puts(isFlat ? "" : "   GROWS");
    std::fflush(stdout);
    return isFlat;
}

/// The crank's time is the picture's own.
struct Wound : MechanismPicture {
    static void by(MechanismPicture* picture, double seconds) {
        void (MechanismPicture::*play)(double) = &Wound::play;
        (picture->*play)(seconds);
    }
};

void settle(const MainWindow& window) {
    QElapsedTimer waited;
    waited.start();
    do {
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    } while (window.currentPage()->isBusy() && waited.elapsed() < 20'000);
}

}  // namespace

int main(int argc, char** argv) {
    const QTemporaryDir home;
    qputenv("XDG_CONFIG_HOME", home.filePath(u"config"_s).toLocal8Bit());
    qputenv("XDG_DATA_HOME", home.filePath(u"data"_s).toLocal8Bit());
    QApplication app(argc, argv);
    QApplication::setApplicationName(u"Ravnoves"_s);
    QApplication::setOrganizationName(u"Ravnoves"_s);
    installLanguage(u"en"_s);
    Theme::instance().install(Theme::Mode::Light);
    const double share = argc > 1 ? std::clamp(std::atof(argv[1]), 0.001, 1.0) : 1.0;
    const auto part = [share](double whole) {
        return std::max(5, static_cast<int>(share * whole));
    };
    bool isFlat = true;

    MainWindow window;
    window.resize(1280, 800);
    window.showScene(u"balance-shaft"_s);
    window.show();

    // Sliders: a hundred moves are one drag and one step of the history.
    constexpr int drag = 100;
    for (const char* scene : {"balance-shaft", "elastic-hinge", "inertia-moments"}) {
        window.showScene(QLatin1String(scene));
        settle(window);
        QList<ValueSlider*> sliders = window.currentPage()->findChildren<ValueSlider*>();
        sliders.removeIf([](ValueSlider* each) { return !each->slider()->isVisible(); });
        if (sliders.isEmpty()) {
            std::printf("%s has no slider\n", scene);
            return 2;
        }
        isFlat &= flat(
            qPrintable(u"sliders of %1"_s.arg(QLatin1String(scene))), part(1e5 / 3.0), [&](int i) {
                ValueSlider* each = sliders[i / drag % sliders.size()];
                QSlider* slider = each->slider();
                if (i % drag == 0) {
                    slider->setSliderDown(true);
                }
                const int range = slider->maximum() - slider->minimum();
                slider->setSliderPosition(slider->minimum() + (i * 37 + i / drag) % (range + 1));
                QApplication::processEvents();
                if (i % drag == drag - 1) {
                    slider->setSliderDown(false);
                    QApplication::processEvents();
                }
            });
        // What was dragged is no case of anybody.
        window.currentPage()->model()->history()->setIndex(0);
        window.currentPage()->model()->history()->clear();
    }

    const QDir examples(u":/examples"_s);
    QStringList files;
    for (const QString& name : examples.entryList({u"*.case.json"_s})) {
        const QString path = home.filePath(name);
        QFile::copy(examples.filePath(name), path);
        files << path;
    }
    if (files.isEmpty()) {
        std::puts("there are no examples");
        return 2;
    }
    isFlat &= flat("cases opened and closed", part(1e3), [&](int i) {
        const QString trouble = window.openCase(files[i % files.size()]);
        if (!trouble.isEmpty()) {
            std::printf("%s\n", qPrintable(trouble));
        }
        QApplication::processEvents();
        window.documents().close(window.documents().current());
        QApplication::processEvents();
    });

    // An hour in steps of a twentieth of a second.
    constexpr double second = 1.0;
    constexpr double step = 0.05;
    constexpr double hour = 3600.0 * second;
    const QStringList moving{u"balance-shaft"_s, u"elastic-hinge"_s};
    for (const QString& scene : moving) {
        window.showScene(scene);
        settle(window);
        auto* picture = window.currentPage()->findChild<MechanismPicture*>();
        if (picture == nullptr) {
            std::printf("%s has no animation\n", qPrintable(scene));
            return 2;
        }
        isFlat &= flat(qPrintable(u"an hour's animation, "_s + scene),
                       part(hour / step / static_cast<double>(moving.size())), [&](int) {
                           Wound::by(picture, step);
                           QApplication::processEvents();
                       });
    }
    std::printf("%s: at most %.0f MiB in each part\n", isFlat ? "flat" : "GROWS", allowed);
    return isFlat ? 0 : 1;
}
