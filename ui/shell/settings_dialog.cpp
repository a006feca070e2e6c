#include "shell/settings_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>

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

}  // namespace

SettingsDialog::SettingsDialog(QWidget* parent) : QDialog(parent) {
    columnIn(this)->setSizeConstraint(QLayout::SetFixedSize);
    build();
    connect(&Preferences::instance(), &Preferences::changed, this, &SettingsDialog::build);
}

template <typename Take>
QComboBox* SettingsDialog::addChoice(const char* name, const QString& label, const QString& hint,
                                     const Choices& choices, const QVariant& present, Take take) {
    auto* box = new QComboBox(rows_->parentWidget());
    box->setObjectName(QLatin1String(name));
    for (const auto& [text, data] : choices) {
        box->addItem(text, data);
    }
    box->setCurrentIndex(box->findData(present));
    box->setToolTip(hint);
    box->setAccessibleDescription(hint);
    rows_->addRow(label, box);
    QString spoken = label;
    box->setAccessibleName(spoken.remove(QLatin1Char('&')));
    connect(box, &QComboBox::activated, this,
            [box, take](int index) { take(box->itemData(index)); });
    return box;
}

void SettingsDialog::build() {
    const QString focused = focusWidget() != nullptr ? focusWidget()->objectName() : QString();
    if (content_ != nullptr) {
        // A box of it may be what has just been chosen in.
        content_->hide();
        content_->setObjectName({});
        for (QWidget* each : content_->findChildren<QWidget*>()) {
            each->setObjectName({});
        }
        content_->deleteLater();
    }
    setWindowTitle(tr("Settings"));
    content_ = new QWidget(this);
    layout()->addWidget(content_);
    auto* form = new QWidget(content_);
    rows_ = new QFormLayout(form);
    rows_->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    rows_->setSpacing(Theme::space);
    Preferences& preferences = Preferences::instance();

    Choices languages{{tr("System default"), QString()}};
    for (const Language& language : availableLanguages()) {
        languages.append({language.ownName, language.code});
    }
    addChoice("language", tr("&Language"), tr("Language of texts and numbers."), languages,
              wantedLanguage(),
              [](const QVariant& code) { Preferences::instance().setLanguage(code.toString()); });

    addChoice("theme", tr("&Theme"), tr("Light or dark colours."),
              {{tr("System default"), static_cast<int>(Theme::Mode::System)},
               {tr("Light"), static_cast<int>(Theme::Mode::Light)},
               {tr("Dark"), static_cast<int>(Theme::Mode::Dark)}},
              static_cast<int>(Theme::instance().mode()), [](const QVariant& mode) {
                  Theme::instance().setMode(static_cast<Theme::Mode>(mode.toInt()));
                  QSettings().setValue(QStringLiteral("view/theme"), mode.toInt());
              });

    const int present = qRound(100.0 * Theme::instance().textScale());
    Choices sizes{{tr("small, 85 %"), 85},
                  {tr("normal, 100 %"), 100},
                  {tr("large, 125 %"), 125},
                  {tr("very large, 150 %"), 150},
                  {tr("largest, 200 %"), 200}};
    if (std::none_of(sizes.begin(), sizes.end(),
                     [&](const auto& size) { return size.second == present; })) {
        sizes.append({QStringLiteral("%1 %").arg(present), present});
    }
    addChoice("text", tr("Te&xt size"), tr("Size of all texts and fields."), sizes, present,
              [](const QVariant& percent) {
                  Theme::instance().setTextScale(percent.toInt() / 100.0);
                  QSettings().setValue(QStringLiteral("view/text"), percent.toInt());
                  Preferences::instance().tell();
              });

    Choices digits{{tr("automatic"), 0}};
    for (int count = Preferences::fewestDigits; count <= Preferences::maxDigits; ++count) {
        digits.append({tr("%1 significant digits").arg(count), count});
    }
    addChoice("digits", tr("&Digits of results"),
              tr("Automatic: digits as needed. Copies and exports use the same digits."), digits,
              preferences.digits(),
              [](const QVariant& count) { Preferences::instance().setDigits(count.toInt()); });

    addUnits();

    // With large text all of it may be higher than the screen.
    QScrollArea* area = scrolled(form, content_);
    area->setMinimumWidth(form->sizeHint().width() + area->verticalScrollBar()->sizeHint().width() +
                          4);
    constexpr int reserve = 130;  // buttons, title and what a desktop keeps for itself
    area->setFixedHeight(std::min(form->sizeHint().height() + 2,
                                  screen()->availableSize().height() - Theme::withText(reserve)));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, content_);
    buttons->button(QDialogButtonBox::Close)->setIcon({});  // black on black in the dark theme
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);  // Enter ends an entry
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* column = columnIn(content_);
    column->addWidget(area);
    buttons->setContentsMargins(Theme::margin, 0, Theme::margin, Theme::margin);
    column->addWidget(buttons);
    if (auto* again = content_->findChild<QWidget*>(focused);
        again != nullptr && !focused.isEmpty()) {
        again->setFocus();
    }
}

void SettingsDialog::addUnits() {
    using Units = Preferences::Units;
    const auto add = [this](Preferences::Quantity quantity, const char* name, const QString& label,
                            const QString& own, const QList<std::pair<QString, Units>>& others) {
        Choices choices{{own, static_cast<int>(Units::Own)}};
        for (const auto& [text, units] : others) {
            choices.append({text, static_cast<int>(units)});
        }
        addChoice(name, label,
                  tr("Units of display, input, print and export. Case files keep their own units; "
                     "drawings are in millimetres."),
                  choices, static_cast<int>(Preferences::instance().units(quantity)),
                  [quantity](const QVariant& units) {
                      Preferences::instance().setUnits(quantity, static_cast<Units>(units.toInt()));
                  });
    };
    add(Preferences::Length, "length_unit", tr("L&engths"), tr("millimetres"),
        {{tr("inches"), Units::Imperial}});
    add(Preferences::Mass, "mass_unit", tr("&Masses"), tr("kilograms and grams"),
        {{tr("grams"), Units::Gram}, {tr("pounds and ounces"), Units::Imperial}});
    add(Preferences::Unbalance, "unbalance_unit", tr("&Unbalances"), tr("as the masses"),
        {{unitText(units::gram_mm.name), Units::GramMillimetre},
         {unitText("g·in"), Units::GramInch},
         {unitText("oz·in"), Units::OunceInch}});
    add(Preferences::Torque, "torque_unit", tr("T&orques"), unitText(units::N_m.name),
        {{unitText("lb·ft"), Units::Imperial}});
    add(Preferences::Force, "force_unit", tr("&Forces"), unitText(units::newton.name),
        {{unitText("lbf"), Units::Imperial}});
    add(Preferences::Speed, "speed_unit", tr("&Speeds"), tr("module default"),
        {{unitText(units::rpm.name), Units::Rpm},
         {unitText(units::rad_per_s.name), Units::RadPerSecond}});
}

}  // namespace ravnoves
