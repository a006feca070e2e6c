#include "v8-plugs/engine_sheet.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "theme/theme.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "widgets/form_section.h"
#include "v8-plugs/model/v8_names.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

/// The label with a mnemonic that no other label of the sheet has: the first letter of a word
/// where one is free, else any letter.
QString withMnemonic(QString label, QString& used) {
    for (const bool wordStart : {true, false}) {
        for (qsizetype i = 0; i < label.size(); ++i) {
            const QChar c = label.at(i).toLower();
            const bool onKeyboard = c.isLetter() && c.script() != QChar::Script_Greek;
            if (!onKeyboard || used.contains(c) ||
                (wordStart && i > 0 && !label.at(i - 1).isSpace())) {
                continue;
            }
            used += c;
            return label.insert(i, QLatin1Char('&'));
        }
    }
    return label;
}

QString hintOf(std::string_view key) {
    // Not "tr": lupdate passes over the texts inside a call of that name.
    const auto inWords = [](const char* text) {
        return QCoreApplication::translate("ravnoves::EngineSheet", text);
    };
    if (key == "crank_radius_mm") {
        return inWords(QT_TRANSLATE_NOOP("ravnoves::EngineSheet", "Half the stroke."));
    }
    if (key == "plug_radius_mm") {
        return inWords(QT_TRANSLATE_NOOP(
            "ravnoves::EngineSheet", "From the crank axis to the centre of mass of today's plug."));
    }
    if (key == "new_plug_radius_mm") {
        return inWords(QT_TRANSLATE_NOOP(
            "ravnoves::EngineSheet",
            "From the crank axis to the centre of mass of a plug of the new design."));
    }
    if (key == "steel_plug_mass_g" || key == "aluminium_plug_mass_g") {
        return inWords(QT_TRANSLATE_NOOP("ravnoves::EngineSheet",
                                         "One plug as the scale says, before it is machined."));
    }
    if (key == "new_steel_plug_mass_g" || key == "new_aluminium_plug_mass_g") {
        return inWords(QT_TRANSLATE_NOOP(
            "ravnoves::EngineSheet",
            "One plug of the new design, for which the crankshaft's counterweights are made."));
    }
    if (key == "max_steel_reduction_g" || key == "max_aluminium_reduction_g") {
        return inWords(
            QT_TRANSLATE_NOOP("ravnoves::EngineSheet",
                              "The most that the strength of its walls allows to take off "
                              "one plug."));
    }
    if (key == "rod_coefficient") {
        return inWords(QT_TRANSLATE_NOOP(
            "ravnoves::EngineSheet",
            "Design coefficient of the rod: a heavier big end counts (2 + k) times."));
    }
    if (key == "oil_mass_g") {
        return inWords(
            QT_TRANSLATE_NOOP("ravnoves::EngineSheet",
                              "Oil in the sludge trap of one crankpin of a running engine."));
    }
    if (key == "oil_coefficient") {
        return inWords(QT_TRANSLATE_NOOP(
            "ravnoves::EngineSheet",
            "What the oil counts for on the crankpin's axis, from its centre of mass."));
    }
    if (key == "reciprocating_mass_g") {
        return inWords(
            QT_TRANSLATE_NOOP("ravnoves::EngineSheet",
                              "Nominal mass of piston, pin, rings and the small-end share of "
                              "the rod, one cylinder."));
    }
    return inWords(
        QT_TRANSLATE_NOOP("ravnoves::EngineSheet",
                          "Nominal mass of the rod's big end and its shells, one cylinder."));
}

}  // namespace

EngineSheet::EngineSheet(V8PlugsModel* model, QWidget* parent) : SheetForm(model, parent) {
    QLabel* note = captionLabel({}, this);
    column_->addWidget(note);
    follow([this, note] {
        note->setText(model_->engineNote());
        note->setVisible(!note->text().isEmpty());
    });

    QString mnemonics;  // letters taken, first those of check boxes and buttons
    for (const QString& label :
         {tr("There are &aluminium plugs"), tr("There are plugs of the new &design"),
          tr("&Keep as own engine…"), tr("Rena&me…"), tr("Remo&ve…")}) {
        mnemonics += label.mid(label.indexOf(QLatin1Char('&')) + 1, 1).toLower();
    }
    auto* basic = new FormSection(tr("Crankshaft and today's plugs"), this);
    addValues(basic, EngineGroup::basic, mnemonics);
    column_->addWidget(basic);
    column_->addWidget(flag(tr("There are &aluminium plugs"), QStringLiteral("has_aluminium_plug"),
                            EngineGroup::aluminium_plug, &Engine::has_aluminium_plug));
    auto* aluminium = new FormSection({}, this);
    addValues(aluminium, EngineGroup::aluminium_plug, mnemonics);
    column_->addWidget(aluminium);
    column_->addWidget(flag(tr("There are plugs of the new &design"),
                            QStringLiteral("has_new_plug"), EngineGroup::new_plug,
                            &Engine::has_new_plug));
    auto* newDesign = new FormSection({}, this);
    addValues(newDesign, EngineGroup::new_plug, mnemonics);
    column_->addWidget(newDesign);
    auto* bob = new FormSection(tr("Nominal masses, for the bob weight"), this);
    addValues(bob, EngineGroup::bob_weight, mnemonics);
    column_->addWidget(bob);
    addOwnEngineButtons();
    column_->addStretch();
}

QCheckBox* EngineSheet::flag(const QString& label, const QString& name, EngineGroup group,
                             bool Engine::*member) {
    auto* box = new QCheckBox(label, this);
    box->setObjectName(name);
    box->setFont(Theme::font(Theme::baseSize, true));
    box->setMinimumHeight(fieldHeight - 6);
    QString step = label;
    step.remove(QLatin1Char('&'));
    connect(box, &QCheckBox::toggled, this, [this, step, group, member](bool on) {
        model_->edit(step, [&](Input& input) {
            input.engine.*member = on;
            if (!on) {
                for (const EngineField& field : engine_fields()) {
                    if (field.group == group) {
                        (input.engine.*field.member).reset();
                    }
                }
                if (group == EngineGroup::new_plug) {
                    input.crankshaft = Crankshaft::standard;
                }
            }
        });
    });
    follow([this, box, member] {
        const QSignalBlocker block(box);
        box->setChecked(model_->input().engine.*member);
    });
    order_ << box;
    return box;
}

void EngineSheet::addValues(FormSection* section, EngineGroup group, QString& mnemonics) {
    const Words words;
    for (const EngineField& field : engine_fields()) {
        if (field.group != group) {
            continue;
        }
        NumberField* made = number(
            section, withMnemonic(v8_text::fieldName(words, field.spec.key), mnemonics), field.spec,
            hintOf(field.spec.key),
            [this, field]() -> std::optional<double> {
                const auto& value = model_->input().engine.*field.member;
                return value ? std::optional(in_unit(*value, field.spec)) : std::nullopt;
            },
            [field](Input& input, std::optional<double> value) {
                input.engine.*field.member =
                    value ? std::optional(*value * field.spec.to_si) : std::nullopt;
            });
        made->setPlaceholderText(tr("needed"));
        follow([this, made, field] {
            made->setEnabled(!is_inapplicable(model_->input().engine, field.group));
        });
    }
}

void EngineSheet::addOwnEngineButtons() {
    auto* row = new QHBoxLayout;
    const auto button = [&](const QString& name, const QString& label) {
        auto* made = new QPushButton(label, this);
        made->setObjectName(name);
        made->setMinimumHeight(fieldHeight);
        row->addWidget(made);
        return made;
    };
    connect(button(QStringLiteral("save_engine"), tr("&Keep as own engine…")),
            &QPushButton::clicked, this, &EngineSheet::saveEngine);
    rename_ = button(QStringLiteral("rename_engine"), tr("Rena&me…"));
    connect(rename_, &QPushButton::clicked, this, &EngineSheet::renameEngine);
    remove_ = button(QStringLiteral("remove_engine"), tr("Remo&ve…"));
    connect(remove_, &QPushButton::clicked, this, &EngineSheet::removeEngine);
    const auto show = [this] {
        const bool own = model_->isOwnEngine(model_->engineIndex());
        rename_->setEnabled(own);
        remove_->setEnabled(own);
    };
    follow(show);
    connect(model_, &V8PlugsModel::enginesChanged, this, show);
    row->addStretch();
    column_->addLayout(row);
}

QString EngineSheet::presentName() const {
    return model_->input().preset.empty() ? QString::fromStdString(model_->input().engine.name)
                                          : QString();
}

/// Asks for a name; empty where the user does not want to go on.
QString EngineSheet::askName(const QString& title, const QString& suggestion) {
    bool ok = false;
    const QString name = QInputDialog::getText(this, title, tr("Name of the engine:"),
                                               QLineEdit::Normal, suggestion, &ok);
    if (ok && name.trimmed().isEmpty()) {
        QMessageBox::warning(this, title, tr("The engine needs a name."));
    }
    return ok ? name.trimmed() : QString();
}

void EngineSheet::report(const QString& title, const QString& trouble, const QString& done) {
    if (trouble.isEmpty()) {
        Q_EMIT status(done);
    } else {
        QMessageBox::warning(this, title, trouble);
    }
}

void EngineSheet::saveEngine() {
    const QString title = tr("Keep as own engine");
    const QString name = askName(title, presentName());
    if (name.isEmpty()) {
        return;
    }
    if (model_->hasOwnEngine(name) &&
        QMessageBox::question(
            this, title, tr("An engine “%1” is kept already. Replace its values?").arg(name),
            QMessageBox::Yes | QMessageBox::No, QMessageBox::No) != QMessageBox::Yes) {
        return;
    }
    report(title, model_->saveEngineAs(name), tr("Engine %1 kept.").arg(name));
}

void EngineSheet::renameEngine() {
    const QString title = tr("Rename own engine");
    const QString name = askName(title, presentName());
    if (!name.isEmpty()) {
        report(title, model_->renameEngine(presentName(), name),
               tr("The engine is called %1 now.").arg(name));
    }
}

void EngineSheet::removeEngine() {
    const QString title = tr("Remove engine");
    const QString name = presentName();
    if (QMessageBox::question(this, title, tr("Remove “%1” from your own engines?").arg(name)) ==
        QMessageBox::Yes) {
        report(title, model_->removeEngine(name), tr("Engine %1 removed.").arg(name));
    }
}

}  // namespace ravnoves
