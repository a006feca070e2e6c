#include "shop/model/weigh_again.h"

#include "text/capital.h"

namespace ravnoves {

QString partOfCylinder(const Words& words, shop::Part part, std::size_t cylinder) {
    return words.translate("Workshop", "%1 of cylinder %2")
        .arg(inSentence(words.text(shop::part_word(part).label)))
        .arg(cylinder + 1);
}

QString rodOfCylinder(const Words& words, std::size_t cylinder) {
    return words.translate("Workshop", "rod of cylinder %1").arg(cylinder + 1);
}

QString weighAgainText(const Words& words, const QStringList& parts) {
    return parts.isEmpty() ? QString()
                           : words.translate("Workshop", "Weigh again first: %1.")
                                 .arg(parts.join(QStringLiteral("; ")));
}

}  // namespace ravnoves
