#include "text/field_row.h"

#include "text/message_text.h"

namespace ravnoves {

ResultRow shownRow(const ResultField& field, const std::optional<double>& si) {
    ResultRow row = shownRow(shownText(field.label), si.value_or(0.0), field.unit, field.decimals,
                             shownText(field.hint));
    if (!si) {
        row[1] = QStringLiteral("–");
    }
    return row;
}

}  // namespace ravnoves
