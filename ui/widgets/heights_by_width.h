#pragma once

#include <QFont>
#include <QHash>
#include <QString>

class QLabel;

namespace ravnoves {

/// Heights that a label needs at the widths it was asked about: the layouts ask dozens of times at
/// every step of a resize, about a few widths, and each time a label lays out its text anew.
class HeightsByWidth {
  public:
    /// The height at a width, both in pixels; of one text in one font it is measured once.
    /// @param measure  what the label says by itself
    template <typename Measure>
    int of(const QLabel& label, int width, const Measure& measure) {
        if (const int* known = find(label, width)) {
            return *known;
        }
        return *known_.insert(width, measure(width));
    }

  private:
    const int* find(const QLabel& label, int width);

    QHash<int, int> known_;
    QString text_;
    QFont font_;
};

}  // namespace ravnoves
