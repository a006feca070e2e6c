#pragma once

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "events.h"
#include "methods/model/methods_model.h"

namespace ravnoves::test {

/// Waits until what is chosen has been measured.
inline void waitUntilMeasured(MethodsModel& model) {
    ASSERT_TRUE(comes([&] { return model.shown() != nullptr && !model.isStale(); }));
}

}  // namespace ravnoves::test
