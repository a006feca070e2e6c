#pragma once

#include <QObject>
#include <optional>

#include "workshop/set_search.h"

namespace ravnoves {

class BackgroundJob;

/// Finds which set goes to which cylinder. A page that is seen does not wait for it: what takes
/// longer than a frame is found in the background, the latest search alone.
class PlacingSearch : public QObject {
    Q_OBJECT

  public:
    explicit PlacingSearch(QObject* parent);

    void setInBackground(bool inBackground) { inBackground_ = inBackground; }
    /// Nothing while it is still looked for: found() comes then.
    std::optional<workshop::SetsFound> find(const workshop::SetSearch& search);
    /// True from a find() that found nothing until found().
    bool isSearching() const { return wanted_.has_value(); }

  Q_SIGNALS:
    void found();

  private:
    BackgroundJob* job_;
    bool inBackground_ = false;
    std::optional<workshop::SetSearch> wanted_;
    std::optional<std::pair<workshop::SetSearch, workshop::SetsFound>> kept_;
};

}  // namespace ravnoves
