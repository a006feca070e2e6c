#include "model/editable_table.h"

#include <algorithm>

#include "text/number_text.h"

namespace ravnoves {

std::vector<QStringList> readTextTable(const QString& text) {
    std::vector<QStringList> rows;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        if (line.trimmed().isEmpty()) {
            continue;
        }
        QStringList cells =
            line.split(line.contains(QLatin1Char('\t')) ? QLatin1Char('\t') : QLatin1Char(';'));
        for (QString& cell : cells) {
            cell = cell.trimmed();
        }
        rows.push_back(std::move(cells));
    }
    const auto isNumber = [](const QString& cell) { return readFormNumber(cell).has_value(); };
    if (rows.size() > 1 && std::none_of(rows[0].begin(), rows[0].end(), isNumber)) {
        rows.erase(rows.begin());
    }
    return rows;
}

Qt::ItemFlags EditableTable::flags(const QModelIndex& index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable
                           : Qt::NoItemFlags;
}

}  // namespace ravnoves
