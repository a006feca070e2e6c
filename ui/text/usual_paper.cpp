#include "text/usual_paper.h"

#include <algorithm>
#include <array>

namespace ravnoves {

QPageSize::PageSizeId usualPaper(const QLocale& locale) {
    static constexpr std::array letter{
        QLocale::Belize,       QLocale::Canada,     QLocale::Chile,       QLocale::Colombia,
        QLocale::CostaRica,    QLocale::ElSalvador, QLocale::Guatemala,   QLocale::Mexico,
        QLocale::Nicaragua,    QLocale::Panama,     QLocale::Philippines, QLocale::PuertoRico,
        QLocale::UnitedStates, QLocale::Venezuela};
    return std::find(letter.begin(), letter.end(), locale.territory()) != letter.end()
               ? QPageSize::Letter
               : QPageSize::A4;
}

}  // namespace ravnoves
