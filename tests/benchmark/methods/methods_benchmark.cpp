/// Every method of every kernel with every setting, on the problem of its scene's preset. The names
/// are KERNEL/METHOD/SETTING; time is per run, items per second count evaluations.

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "methods/kernel.h"

namespace {

using namespace ravnoves::methods;

[[maybe_unused]] const bool registered = [] {
    for (const Kernel& kernel : kernels()) {
        const std::shared_ptr<Problem> problem = kernel.present_problem();
        for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
            const MethodInfo& info = kernel.methods[method];
            for (std::size_t setting = 0; setting < info.settings.size(); ++setting) {
                const std::string name =
                    kernel.id + "/" + info.id + "/" + info.settings[setting].label.english();
                benchmark::RegisterBenchmark(
                    name.c_str(), [problem, method, setting](benchmark::State& state) {
                        const Run run = problem->prepare(method, setting);
                        std::vector<double> out(problem->outputs());
                        for (auto _ : state) {
                            benchmark::DoNotOptimize(run(out));
                            benchmark::ClobberMemory();
                        }
                        state.counters["evaluations"] = benchmark::Counter(
                            static_cast<double>(state.iterations()) * problem->evaluations(),
                            benchmark::Counter::kIsRate);
                        const Result result = evaluate(*problem, method, setting);
                        if (result.refused()) {
                            state.SetLabel(result.refusal.english());
                        } else {
                            state.counters["error"] = result.error;
                        }
                    });
            }
        }
    }
    return true;
}();

}  // namespace
