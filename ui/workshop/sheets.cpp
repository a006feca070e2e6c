#include "workshop/sheets.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "theme/theme.h"
#include "widgets/layouts.h"

namespace ravnoves {

void WorkshopSheet::withPlugs(bool there) {
    follow([this, there, made = current()] { made->setVisible(model_->hasPlugs() == there); });
}

QPushButton* WorkshopSheet::button(const char* name, const QString& label, const QString& tip,
                                   std::function<void()> press) {
    auto* made = new QPushButton(label, current());
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setMinimumHeight(Theme::withText(fieldHeight));
    current()->addWide(made);
    connect(made, &QPushButton::clicked, this, std::move(press));
    return made;
}

std::pair<QGridLayout*, TroubleLine*> WorkshopSheet::grid(const QStringList& headings) {
    auto* holder = new QWidget(current());
    auto* made = new QGridLayout(holder);
    made->setContentsMargins(0, 0, 0, 0);
    made->setHorizontalSpacing(Theme::gap);
    made->setVerticalSpacing(Theme::gap);
    current()->addWide(holder);
    auto* trouble = new TroubleLine(current());
    current()->addWide(trouble);
    for (int column = 0; column < headings.size(); ++column) {
        auto* heading = new QLabel(headings.at(column), holder);
        heading->setFont(Theme::font(Theme::smallSize, true));
        heading->setAlignment(Qt::AlignCenter);
        heading->setWordWrap(true);
        made->addWidget(heading, 0, column);
        made->setColumnStretch(column, column == 0 ? 0 : 1);
    }
    return {made, trouble};
}

NumberField* WorkshopSheet::cell(const Field& field, const QString& name, const QString& spoken) {
    auto* made = new NumberField(field, current());
    made->setObjectName(name);
    made->setAccessibleName(spoken);
    made->setOptional(true);
    enlarge(made);
    makeCell(made);
    return made;
}

}  // namespace ravnoves
