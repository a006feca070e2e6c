// What the window computes and writes in other threads, without the window: every path is begun,
// replaced, cancelled and destroyed while it runs. The thread sanitizer looks on; by itself this
// only checks that each comes to its end. With --race one is planted, which the sanitizer must see.

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/model/speed_study_model.h"
#include "elastic-hinge/model/elastic_hinge_model.h"
#include "methods/model/methods_model.h"
#include "model/background_job.h"
#include "studies/model/study_model.h"
#include "studies/model/sweep_model.h"

namespace {

using namespace Qt::StringLiterals;
using namespace ravnoves;

int failures = 0;
bool plants = false;
int planted = 0;

void check(bool holds, const char* what) {
    if (!holds) {
        std::printf("FAILED: %s\n", what);
        ++failures;
    }
}

bool comes(const std::function<bool()>& what, int ms = 120'000) {
    QElapsedTimer waited;
    waited.start();
    while (!what()) {
        if (waited.elapsed() > ms) {
            return false;
        }
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
        std::this_thread::yield();
    }
    return true;
}

void jobs() {
    int delivered = 0;
    std::vector<int> seen;
    for (int round = 0; round < 200; ++round) {
        BackgroundJob job;
        job.setPatience(round % 3 - 1, 0);
        for (int i = 0; i < 4; ++i) {
            job.start([&, i](const BackgroundJob::Progress& progress) -> std::function<void()> {
                std::vector<int> values(100, i);
                if (plants) {
                    ++planted;
                }
                for (int step = 0; step < 100; ++step) {
                    if (!progress(step / 100.0)) {
                        return nullptr;
                    }
                    values[static_cast<std::size_t>(step)] += step;
                }
                return [&, values] {
                    seen = values;
                    ++delivered;
                };
            });
            if (i == 2 && round % 4 == 0) {
                job.cancel();
            }
            if (plants) {
                ++planted;
            }
            QCoreApplication::processEvents();
        }
        if (round % 2 == 0) {
            check(comes([&] { return !job.isRunning(); }), "a job ends");
        }  // else it is destroyed while it runs
    }
    check(delivered > 0, "jobs deliver");
}

void maps() {
    BalanceShaftModel model;
    model.setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    ShaftMapModel& map = *model.shaftMap();
    SpeedStudyModel& speed = *model.speedStudy();
    for (int angle = 60; angle < 72; ++angle) {
        model.setByKey(u"shaft_angle_deg"_s, QString::number(angle));
        model.setLoad(&balance_shaft::GasCycle::imep, (5.0 + 0.01 * angle) * units::bar);
        model.needParts();
        QCoreApplication::processEvents();
    }
    check(comes([&] { return !map.job()->isRunning() && !speed.job()->isRunning(); }),
          "the maps are computed");
}

void runStudies() {
    BalanceShaftModel model;
    StudyModel study(&model);
    study.setWatched(true);
    study.take(StudyModel::Preset::OnePercent);
    const auto results = study.results();
    check(!results.empty(), "there are results");
    study.watch(results.front());
    study.setSamples(256);
    SweepModel sweep(&study);
    sweep.setWatched(true);
    model.setSweepChoice({.input = "/centre_distance_mm", .result = results.front()});
    sweep.follow();
    for (int i = 0; i < 3; ++i) {
        model.setByKey(u"shaft_angle_deg"_s, QString::number(90 + i));
        comes([] { return false; }, 300);
    }
    check(comes([&] { return !study.isBusy() && !sweep.job()->isRunning(); }),
          "the studies are computed");
    model.setByKey(u"shaft_angle_deg"_s, u"100"_s);
    comes([] { return false; }, 200);
}  // and destroyed while they run

void motion() {
    ElasticHingeModel model;
    for (int i = 0; i < 5; ++i) {
        model.setByKey(u"lambda"_s, QString::number(0.3 + 0.01 * i));
        comes([] { return false; }, 50);
    }
    const auto running = model.findChildren<BackgroundJob*>();
    check(comes([&] {
              return std::none_of(running.begin(), running.end(),
                                  [](const BackgroundJob* job) { return job->isRunning(); });
          }),
          "the motion is computed");
}

void measureMethods() {
    MethodsModel model;
    model.setActive(true);
    comes([] { return false; }, 300);
    model.setKernel(1);
    comes([] { return false; }, 100);
    model.setKernel(0);
    check(comes([&] { return model.shown() != nullptr; }), "methods are measured");
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    if (argc == 2 && QCoreApplication::arguments().at(1) == u"--race"_s) {
        plants = true;
        jobs();
        return 0;
    }
    const std::pair<const char*, void (*)()> paths[] = {{"jobs", jobs},
                                                        {"maps", maps},
                                                        {"studies", runStudies},
                                                        {"motion", motion},
                                                        {"methods", measureMethods}};
    for (const auto& [name, path] : paths) {
        std::printf("%s\n", name);
        std::fflush(stdout);
        path();
    }
    std::puts(failures == 0 ? "every path ends" : "FAILED");
    return failures == 0 ? 0 : 1;
}
