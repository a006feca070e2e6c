#pragma once

#include <QApplication>
#include <QPointer>

namespace ravnoves {

/// Lets a filter see every event of the program; once for each kind of filter, further calls do
/// nothing.
template <typename Filter>
void filterApplication() {
    static QPointer<Filter> filter;
    if (filter.isNull()) {
        filter = new Filter(qApp);
        qApp->installEventFilter(filter);
    }
}

}  // namespace ravnoves
