#include "shell/settings_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>
#include <algorithm>
#include <functional>

#include "numerics/units.h"
#include "text/language.h"
#include "text/number_text.h"
#include "text/preferences.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"

namespace ravnoves {

namespace {

using Choices = QList<std::pair<QString, QVariant>>;

/// A setting: `take` gets the data of what the user chose where that is another.
struct Row {
    const char* name;
    QString label;
    QString hint;
    Choices choices;
    QVariant present;
    std::function<void(const QVariant&)> take;
};

}  // namespace

SettingsDialog::SettingsDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Settings"));
    auto* form = new QWidget(this);
    auto* list = new QFormLayout(form);
    list->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    list->setSpacing(Theme::space);
    Preferences& preferences = Preferences::instance();

    Choices languages{{tr("System default"), QString()}};
    for (const Language& language : availableLanguages()) {
        languages.append({language.ownName, language.code});
    }
    const int size = qRound(100.0 * Theme::instance().textScale());
    Choices sizes{{tr("small, 85 %"), 85},
                  {tr("normal, 100 %"), 100},
                  {tr("large, 125 %"), 125},
                  {tr("very large, 150 %"), 150},
                  {tr("largest, 200 %"), 200}};
    if (!std::ranges::count(sizes, QVariant(size), &std::pair<QString, QVariant>::second)) {
        sizes.append({QStringLiteral("%1 %").arg(size), size});
    }
    Choices digits{{tr("automatic"), 0}};
    for (int count = Preferences::fewestDigits; count <= Preferences::maxDigits; ++count) {
        digits.append({tr("%1 significant digits").arg(count), count});
    }
    using Units = Preferences::Units;
    const auto unitsOf = [&](const char* name, const QString& label, Preferences::Quantity quantity,
                             const QString& own, const QList<std::pair<QString, Units>>& others) {
        Choices choices{{own, static_cast<int>(Units::Own)}};
        for (const auto& [text, unit] : others) {
            choices.append({text, static_cast<int>(unit)});
        }
        return Row{name,
                   label,
                   tr("Units of display, input, print and export. Case files keep their own units; "
                      "drawings are in millimetres."),
                   choices,
                   static_cast<int>(preferences.units(quantity)),
                   [quantity](const QVariant& unit) {
                       Preferences::instance().setUnits(quantity, static_cast<Units>(unit.toInt()));
                   }};
    };
    const Row rows[]{
        {"language", tr("&Language"), tr("Language of texts and numbers."), languages,
         wantedLanguage(),
         [](const QVariant& code) { Preferences::instance().setLanguage(code.toString()); }},
        {"theme",
         tr("&Theme"),
         tr("Light or dark colours."),
         {{tr("System default"), static_cast<int>(Theme::Mode::System)},
          {tr("Light"), static_cast<int>(Theme::Mode::Light)},
          {tr("Dark"), static_cast<int>(Theme::Mode::Dark)}},
         static_cast<int>(Theme::instance().mode()),
         [](const QVariant& mode) {
             Theme::instance().setMode(static_cast<Theme::Mode>(mode.toInt()));
             QSettings().setValue(QStringLiteral("view/theme"), mode.toInt());
         }},
        {"text", tr("Te&xt size"), tr("Size of all texts and fields."), sizes, size,
         [](const QVariant& percent) {
             Theme::instance().setTextScale(percent.toInt() / 100.0);
             QSettings().setValue(QStringLiteral("view/text"), percent.toInt());
             Preferences::instance().tell();
         }},
        {"digits", tr("&Digits of results"),
         tr("Automatic: digits as needed. Copies and exports use the same digits."), digits,
         preferences.digits(),
         [](const QVariant& count) { Preferences::instance().setDigits(count.toInt()); }},
        unitsOf("length_unit", tr("L&engths"), Preferences::Length, tr("millimetres"),
                {{tr("inches"), Units::Imperial}}),
        unitsOf("mass_unit", tr("&Masses"), Preferences::Mass, tr("kilograms and grams"),
                {{tr("grams"), Units::Gram}, {tr("pounds and ounces"), Units::Imperial}}),
        unitsOf("unbalance_unit", tr("&Unbalances"), Preferences::Unbalance, tr("as the masses"),
                {{unitText(units::gram_mm.name), Units::GramMillimetre},
                 {unitText("g·in"), Units::GramInch},
                 {unitText("oz·in"), Units::OunceInch}}),
        unitsOf("torque_unit", tr("T&orques"), Preferences::Torque, unitText(units::N_m.name),
                {{unitText("lb·ft"), Units::Imperial}}),
        unitsOf("force_unit", tr("&Forces"), Preferences::Force, unitText(units::newton.name),
                {{unitText("lbf"), Units::Imperial}}),
        unitsOf("speed_unit", tr("&Speeds"), Preferences::Speed, tr("module default"),
                {{unitText(units::rpm.name), Units::Rpm},
                 {unitText(units::rad_per_s.name), Units::RadPerSecond}}),
    };
    for (const Row& row : rows) {
        auto* box = new QComboBox(form);
        box->setObjectName(QLatin1String(row.name));
        for (const auto& [text, data] : row.choices) {
            box->addItem(text, data);
        }
        box->setCurrentIndex(box->findData(row.present));
        box->setToolTip(row.hint);
        box->setAccessibleDescription(row.hint);
        list->addRow(row.label, box);
        box->setAccessibleName(QString(row.label).remove(QLatin1Char('&')));
        connect(this, &QDialog::accepted, box, [box, row] {
            if (box->currentData() != row.present) {
                row.take(box->currentData());
            }
        });
    }

    // With large text all of it may be higher than the screen.
    QScrollArea* area = scrolled(form, this);
    area->setMinimumWidth(form->sizeHint().width() + area->verticalScrollBar()->sizeHint().width() +
                          4);
    constexpr int reserve = 130;  // buttons, title and what a desktop keeps for itself
    area->setFixedHeight(std::min(form->sizeHint().height() + 2,
                                  screen()->availableSize().height() - Theme::withText(reserve)));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = columnIn(this);
    column->setSizeConstraint(QLayout::SetFixedSize);
    column->addWidget(area);
    buttons->setContentsMargins(Theme::margin, 0, Theme::margin, Theme::margin);
    column->addWidget(buttons);
}

}  // namespace ravnoves
