/// Times the pages' frames: from a change of value to the painted page, in one process without a
/// display. Each page drags its main slider over 500 steps; the 95th percentile of the drawing
/// thread's own processor time is printed, and what share it is of the rival's just before: a plain
/// window with three QChartView, seven series of 721 points, antialiased, whose step is `replace()`
/// alone. In lines for table.py.
///
/// Then the wheel over the largest plot, the cursor in it and the window's size, likewise; the
/// plain window's size too.
///
/// bench-ui-frames [PAGE] [--steps N] [--size WxH] [--only GESTURE] [--alone]
/// --only: drag, wheel, cursor or resize; --alone: without the rival, for a profile of the page.

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QGridLayout>
#include <QLineSeries>
#include <QMouseEvent>
#include <QProcess>
#include <QScreen>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "elastic-hinge/elastic_hinge_page.h"
#include "elastic-hinge/model/elastic_hinge_model.h"
#include "inertia-moments/inertia_moments_page.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "methods/methods_page.h"
#include "model/background_job.h"
#include "numerics/constants.h"
#include "plot/plot_view.h"
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
             showTabOf(page->findChild<QWidget*>(QStringLiteral("map")));
             page->show();
             ShaftMapModel* map = page->viewModel()->shaftMap();
             while (map->job()->isRunning()) {
                 QApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
             }
             return Drag{
                 page, [map](int step, int steps) {
                     const double way = static_cast<double>(step) / steps;
                     map->moveTo({0.12 * way - 0.02, 0.09 - 0.15 * way}, ShaftMapModel::Snapped);
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
                             page->viewModel()->dragField("/layout/bank_angle_deg",
                                                          5.0 + 85.0 * step / steps,
                                                          QStringLiteral("γ"));
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

struct Options {
    int steps = 500;
    QSize size{1280, 800};
    QString only;  ///< gesture

    bool wants(const char* gesture) const {
        return only.isEmpty() || only == QLatin1String(gesture);
    }
};

/// Takes so many steps, each of which is painted, and prints the time that 95 of 100 take.
void time(const std::string& name, const Options& options, const std::function<void(int)>& step,
          std::optional<double>& rival) {
    std::vector<double> processor;
    for (int i = 0; i < options.steps; ++i) {
        const double before = processorMs();
        step(i);
        // One turn of the loop paints what the change has queued, once.
        QApplication::processEvents();
        processor.push_back(processorMs() - before);
    }
    std::sort(processor.begin(), processor.end());
    const double p95 =
        processor[static_cast<std::size_t>(0.95 * static_cast<double>(processor.size() - 1))];
    rival = rival.value_or(p95);
    const double scale = QGuiApplication::primaryScreen()->devicePixelRatio();
    std::printf("frame p95, %s, %dx%d%s | %.2f ms | %.2f ms | %.2f\n", name.c_str(),
                options.size.width(), options.size.height(), scale > 1.0 ? ", scale 2" : "", p95,
                *rival, p95 / *rival);
}

/// The largest plot to be seen.
PlotView* largestPlot(QWidget* page) {
    PlotView* largest = nullptr;
    for (PlotView* plot : page->findChildren<PlotView*>()) {
        if (!plot->visibleRegion().isEmpty() &&
            (largest == nullptr ||
             plot->width() * plot->height() > largest->width() * largest->height())) {
            largest = plot;
        }
    }
    return largest;
}

/// What the hand does beside dragging: the wheel zooms, the cursor reads, the window is resized.
void timeGestures(const std::string& name, const Options& options, QWidget* page,
                  std::optional<double>& rival) {
    if (PlotView* plot = largestPlot(page)) {
        const auto place = [plot](int step) {
            const QRectF area = plot->plotArea();
            return QPointF(area.left() + area.width() * (0.1 + 0.8 * (step % 97) / 97.0),
                           area.center().y());
        };
        const auto wheel = [&](int step) {
            const QPointF at = place(step);
            // Ten notches in, ten out.
            QWheelEvent event(at, plot->mapToGlobal(at), {}, {0, step % 20 < 10 ? 120 : -120},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(plot, &event);
        };
        if (options.wants("wheel")) {
            time(name + ", wheel", options, wheel, rival);
            plot->resetZoom();
        }
        const auto move = [&](int step) {
            const QPointF at = place(step);
            QMouseEvent event(QEvent::MouseMove, at, plot->mapToGlobal(at), Qt::NoButton,
                              Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(plot, &event);
        };
        if (options.wants("cursor")) {
            time(name + ", cursor", options, move, rival);
        }
    }
    const auto resize = [&](int step) {
        page->resize(options.size - QSize(3, 2) * (step % 40 < 20 ? step % 20 : 20 - step % 20));
    };
    if (options.wants("resize")) {
        time(name + ", resize", options, resize, rival);
    }
}

void run(const std::string& name, const std::function<Drag()>& make, const Options& options,
         std::optional<double>& rival) {
    const bool isRival = !rival;
    const Drag drag = make();
    drag.page->resize(options.size);
    drag.page->show();
    for (int turn = 0; turn < 5; ++turn) {
        QApplication::processEvents();
    }
    if (isRival || options.wants("drag")) {
        time(
            name, options, [&](int step) { drag.move(step, options.steps); }, rival);
    }
    Options few = options;
    few.steps = options.only.isEmpty() ? std::min(options.steps, 200) : options.steps;
    timeGestures(name, few, drag.page, rival);
    delete drag.page;
}

/// The plain window's drag, in a process of its own, which prints what it took.
double rivalTime(QStringList arguments) {
    QProcess process;
    const QString program = QCoreApplication::applicationFilePath();
    arguments.removeFirst();
    process.start(program, arguments << QStringLiteral("--rival"));
    process.waitForFinished(-1);
    QStringList lines =
        QString::fromUtf8(process.readAllStandardOutput()).trimmed().split(QLatin1Char('\n'));
    const double p95 = lines.takeLast().toDouble();
    for (const QString& line : lines) {
        std::printf("%s\n", qPrintable(line));
    }
    return p95;
}

}  // namespace

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    const bool isRival = argc > 1 && std::string_view(argv[argc - 1]) == "--rival";
    QApplication app(argc, argv);
    installLanguage(QStringLiteral("en"));
    Theme::instance().install(Theme::Mode::Light);
    std::string only;
    Options options;
    bool alone = false;
    const QStringList arguments = QApplication::arguments();
    for (int i = 1; i < arguments.size(); ++i) {
        if (arguments[i] == QLatin1String("--steps") && i + 1 < arguments.size()) {
            options.steps = std::max(2, arguments[++i].toInt());
        } else if (arguments[i] == QLatin1String("--size") && i + 1 < arguments.size()) {
            const QStringList parts = arguments[++i].split(QLatin1Char('x'));
            options.size = QSize(parts.value(0).toInt(), parts.value(1).toInt());
        } else if (arguments[i] == QLatin1String("--only") && i + 1 < arguments.size()) {
            options.only = arguments[++i];
        } else if (arguments[i] == QLatin1String("--alone")) {
            alone = true;
        } else if (arguments[i] != QLatin1String("--rival")) {
            only = arguments[i].toStdString();
        }
    }
    std::optional<double> rival;
    if (isRival) {
        run("plain window", plainWindow, options, rival);
        std::printf("%.6f\n", *rival);
        return 0;
    }
    for (const auto& [name, make] : drags()) {
        if (only.empty() || name.starts_with(only)) {
            // Anew before each page: a shared machine changes its speed within minutes.
            rival = alone ? 1.0 : rivalTime(arguments);
            run(name, make, options, rival);
        }
    }
    return 0;
}
