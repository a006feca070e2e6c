#pragma once

#include <QLocale>
#include <QPageSize>

namespace ravnoves {

/// Letter where the locale's country prints on it, else A4.
///
/// Source: Unicode CLDR, supplemental data, measurementData, paperSize US-Letter.
/// @param locale  of the desktop: an English program in Berlin prints on A4
QPageSize::PageSizeId usualPaper(const QLocale& locale = QLocale::system());

}  // namespace ravnoves
