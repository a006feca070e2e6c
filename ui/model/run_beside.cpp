#include "model/run_beside.h"

#include <QEventLoop>
#include <exception>

#include "model/worker_thread.h"
#include "numerics/vector_state.h"

namespace ravnoves {

void runBeside(const std::function<void()>& work) {
    std::exception_ptr thrown;
    {
        QEventLoop loop;
        WorkerThread worker;
        worker.begin([&]() -> WorkerThread::Telling {
            clear_vector_state();
            try {
                work();
            } catch (...) {
                thrown = std::current_exception();
            }
            return [&loop] { loop.quit(); };
        });
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    }  // the thread has ended
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

}  // namespace ravnoves
