#include "studies/model/result_words.h"

#include <QStringList>

#include "text/key_words.h"
#include "text/number_text.h"

namespace ravnoves {

ResultName nameByKeys(const std::string& pointer) {
    ResultName name;
    QStringList parts;
    for (QString key :
         QString::fromStdString(pointer).split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        if (const Unit unit = takeUnit(key); unit != units::none) {
            name.unit = unitText(unit.name);
        }
        parts << keyInWords(key.toStdString());
    }
    name.text = parts.join(QStringLiteral(", "));
    return name;
}

}  // namespace ravnoves
