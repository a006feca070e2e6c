/// Times the pages' frames: from a change of value to the painted page, in one process without a
/// display. Each page drags its main slider over 500 steps; median and p95 are printed, of wall
/// time and of the drawing thread's own processor time (which a busy machine disturbs less), and
/// what share they are of the rival's in the same run: a plain window with three QChartView, seven
/// series of 721 points, antialiased, whose step is `replace()` alone.
///
/// bench-ui-frames [PAGE] [--steps N] [--size WxH] [--alone]
/// --alone: without the rival, for a profile of the page.

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QElapsedTimer>
#include <QGridLayout>
#include <QLineSeries>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <optional>
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
#include "numerics/constants.h"
#include "text/language.h"
#include "theme/theme.h"
#include "widgets/page_columns.h"

namespace {

using namespace ravnoves;

struct Drag {
    QWidget* page;
    std::function<void(int step, int steps)> move;
};

/// What a user would write in an afternoon.
Drag plainWindow() {
    auto* window = new QWidget;
    auto* grid = new QGridLayout(window);
    std::vector<QLineSeries*> curves;
    for (const int count : {3, 2, 2}) {
        auto* chart = new QChart;
        for (int i = 0; i < count; ++i) {
            auto* curve = new QLineSeries;
            curve->setName(QStringLiteral("M%1").arg(i));
            chart->addSeries(curve);
            curves.push_back(curve);
        }
        chart->createDefaultAxes();
        chart->axes(Qt::Horizontal).constFirst()->setRange(0.0, 720.0);
        chart->axes(Qt::Vertical).constFirst()->setRange(-2.0, 2.0);
        auto* view = new QChartView(chart);
        view->setRenderHint(QPainter::Antialiasing);
        count == 3 ? grid->addWidget(view, 0, 0, 1, 2)
                   : grid->addWidget(view, 1, grid->count() - 1);
    }
    return {
        window, [curves](int step, int steps) {
            for (std::size_t k = 0; k < curves.size(); ++k) {
                const double phase = two_pi * step / steps + 0.4 * static_cast<double>(k);
                QList<QPointF> points;
                points.reserve(721);
                for (int i = 0; i <= 720; ++i) {
                    const double phi = i * degree;
                    points.append(QPointF(i, std::sin(phi + phase) + 0.4 * std::sin(3.0 * phi)));
                }
                curves[k]->replace(points);
            }
        }};
}

struct Times {
    double median;
    double p95;
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
             showTabOf(view);
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

/// @param rival  of the plain window; none while it is measured itself
/// @return the processor times, ms
Times run(const std::string& name, const std::function<Drag()>& make, int steps, QSize size,
          const std::optional<Times>& rival) {
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
        "processor: median %6.2f p95 %6.2f ms",
        name.c_str(), steps, size.width(), size.height(), at(wall, 0.5), at(wall, 0.95),
        at(wall, 1.0), at(processor, 0.5), at(processor, 0.95));
    const Times own{at(processor, 0.5), at(processor, 0.95)};
    if (rival) {
        std::printf("  share: median %4.2f p95 %4.2f", own.median / rival->median,
                    own.p95 / rival->p95);
    }
    std::printf("\n");
    delete drag.page;
    return own;
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
    bool alone = false;
    QSize size(1280, 800);
    const QStringList arguments = QApplication::arguments();
    for (int i = 1; i < arguments.size(); ++i) {
        if (arguments[i] == QLatin1String("--steps") && i + 1 < arguments.size()) {
            steps = std::max(2, arguments[++i].toInt());
        } else if (arguments[i] == QLatin1String("--size") && i + 1 < arguments.size()) {
            const QStringList parts = arguments[++i].split(QLatin1Char('x'));
            size = QSize(parts.value(0).toInt(), parts.value(1).toInt());
        } else if (arguments[i] == QLatin1String("--alone")) {
            alone = true;
        } else {
            only = arguments[i].toStdString();
        }
    }
    std::optional<Times> rival;
    if (!alone) {
        rival = run("plain window", plainWindow, steps, size, std::nullopt);
    }
    for (const auto& [name, make] : drags()) {
        if (only.empty() || name.starts_with(only)) {
            run(name, make, steps, size, rival);
        }
    }
    return 0;
}
