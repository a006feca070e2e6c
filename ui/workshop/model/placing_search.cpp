#include "workshop/model/placing_search.h"

#include "model/background_job.h"

namespace ravnoves {

using workshop::SetSearch;
using workshop::SetsFound;

PlacingSearch::PlacingSearch(QObject* parent) : QObject(parent), job_(new BackgroundJob(this)) {}

std::optional<SetsFound> PlacingSearch::find(const SetSearch& search) {
    if (kept_ && kept_->first == search) {
        job_->cancel();
        wanted_.reset();
        return kept_->second;
    }
    if (!inBackground_ || workshop::is_quick(search)) {
        job_->cancel();
        wanted_.reset();
        kept_ = {search, workshop::best_placing(search)};
        return kept_->second;
    }
    if (wanted_ != search) {
        wanted_ = search;
        job_->start([this, search](const BackgroundJob::Progress&) -> std::function<void()> {
            return [this, search, placing = workshop::best_placing(search)] {
                kept_ = {search, placing};
                wanted_.reset();
                Q_EMIT found();
            };
        });
    }
    return std::nullopt;
}

}  // namespace ravnoves
