/// Times the pages' frames: from a change of value to the painted page, in one process without a
/// display. Each page drags its main slider over 500 steps; median and p95 are printed, of wall
/// time and of the drawing thread's own processor time (which a busy machine disturbs less).
///
/// bench-ui-frames [PAGE] [--steps N] [--size WxH]

#include <QApplication>
#include <QElapsedTimer>
#include <QTabWidget>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/shaft_map_view.h"
#include "elastic-hinge/elastic_hinge_page.h"
#include "elastic-hinge/model/elastic_hinge_model.h"
#include "inertia-moments/inertia_moments_page.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "methods/methods_page.h"
#include "model/background_job.h"
#include "text/language.h"
#include "theme/theme.h"

namespace {

using namespace ravnoves;

struct Drag {
    QWidget* page;
    std::function<void(int step, int steps)> move;
};

/// One entry per page: the page and what a step of its slider does.
std::map<std::string, std::function<Drag()>> drags() {
    return {
        {"balance-shaft",
         [] {
             auto* page = new BalanceShaftPage;
             return Drag{page, [page](int step, int steps) {
                             page->viewModel()->setShaftAngleDeg(360.0 * step / steps);
                         }};
         }},
        {"balance-shaft, axis",
         [] {
             auto* page = new BalanceShaftPage;
             auto* view = page->findChild<ShaftMapView*>();
             page->views()->setCurrentWidget(view);
             page->show();
             while (view->mapModel()->job()->isRunning()) {
                 QApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
             }
             return Drag{page, [view](int step, int steps) {
                             const double way = static_cast<double>(step) / steps;
                             view->mapModel()->dragTo({0.12 * way - 0.02, 0.09 - 0.15 * way});
                         }};
         }},
        {"elastic-hinge, speed",
         [] {
             auto* page = new ElasticHingePage;
             return Drag{page, [page](int step, int steps) {
                             page->viewModel()->drag(QStringLiteral("speed"), [&](auto& input) {
                                 input.angular_speed = 50.0 + 450.0 * step / steps;
                             });
                         }};
         }},
        {"elastic-hinge, lambda",
         [] {
             auto* page = new ElasticHingePage;
             return Drag{page, [page](int step, int steps) {
                             page->viewModel()->drag(QStringLiteral("lambda"), [&](auto& input) {
                                 input.lambda = 0.1 + 0.8 * step / steps;
                             });
                         }};
         }},
        {"inertia-moments",
         [] {
             auto* page = new InertiaMomentsPage;
             return Drag{page, [page](int step, int steps) {
                             page->viewModel()->setBankAngleDeg(5.0 + 85.0 * step / steps);
                         }};
         }},
        {"methods",
         [] {
             auto* page = new MethodsPage;
             MethodsModel* model = page->viewModel();
             // With a measurement in the charts; the drag itself measures nothing.
             page->setActive(true);
             while (model->shown() == nullptr || model->isStale()) {
                 QApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
             }
             return Drag{page, [model](int step, int steps) {
                             model->setValue(model->sweep().at(static_cast<double>(step) / steps));
                         }};
         }},
    };
}

/// Processor time of this thread, ms: a worker thread's does not count.
double processorMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void run(const std::string& name, const std::function<Drag()>& make, int steps, QSize size) {
    const Drag drag = make();
    drag.page->resize(size);
    drag.page->show();
    for (int turn = 0; turn < 5; ++turn) {
        QApplication::processEvents();
    }
    std::vector<double> wall;
    std::vector<double> processor;
    for (int step = 0; step < steps; ++step) {
        QElapsedTimer timer;
        timer.start();
        const double before = processorMs();
        drag.move(step, steps);
        // One turn of the loop paints what the change has queued, once.
        QApplication::processEvents();
        wall.push_back(static_cast<double>(timer.nsecsElapsed()) * 1e-6);
        processor.push_back(processorMs() - before);
    }
    std::sort(wall.begin(), wall.end());
    std::sort(processor.begin(), processor.end());
    const auto at = [&](const std::vector<double>& sorted, double share) {
        return sorted[static_cast<std::size_t>(share * static_cast<double>(steps - 1))];
    };
    std::printf(
        "%-21s %4d steps %4dx%-4d  wall: median %6.2f p95 %6.2f max %6.2f ms  "
        "processor: median %6.2f p95 %6.2f ms\n",
        name.c_str(), steps, size.width(), size.height(), at(wall, 0.5), at(wall, 0.95),
        at(wall, 1.0), at(processor, 0.5), at(processor, 0.95));
    delete drag.page;
}

}  // namespace

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication app(argc, argv);
    installLanguage(QStringLiteral("en"));
    Theme::instance().install(Theme::Mode::Light);
    std::string only;
    int steps = 500;
    QSize size(1280, 800);
    const QStringList arguments = QApplication::arguments();
    for (int i = 1; i < arguments.size(); ++i) {
        if (arguments[i] == QLatin1String("--steps") && i + 1 < arguments.size()) {
            steps = std::max(2, arguments[++i].toInt());
        } else if (arguments[i] == QLatin1String("--size") && i + 1 < arguments.size()) {
            const QStringList parts = arguments[++i].split(QLatin1Char('x'));
            size = QSize(parts.value(0).toInt(), parts.value(1).toInt());
        } else {
            only = arguments[i].toStdString();
        }
    }
    for (const auto& [name, make] : drags()) {
        if (only.empty() || name.starts_with(only)) {
            run(name, make, steps, size);
        }
    }
    return 0;
}
