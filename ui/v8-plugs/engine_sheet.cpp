#include "v8-plugs/engine_sheet.h"

#include <QCheckBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>

#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/text_length.h"

namespace ravnoves {

using namespace v8_plugs;

EngineSheet::EngineSheet(V8PlugsModel* model, QWidget* parent) : V8Sheet(model, parent) {
    section(tr("Crankshaft and today's plugs"));
    addValues(EngineGroup::basic);
    section({});
    addPlugs(tr("There are &aluminium plugs"), QStringLiteral("has_aluminium_plug"),
             tr("Aluminium plugs in place of the steel ones count among the options."),
             EngineGroup::aluminium_plug, &Engine::has_aluminium_plug);
    section({});
    addPlugs(tr("There are plugs of the new &design"), QStringLiteral("has_new_plug"),
             tr("Their options count where a crankshaft made for them is fitted."),
             EngineGroup::new_plug, &Engine::has_new_plug);
    section(tr("Nominal masses, for the bob weight"));
    addValues(EngineGroup::bob_weight);
    auto* fill = new QPushButton(tr("&Fill from the nominal parts"), this);
    fill->setObjectName(QStringLiteral("fill_masses"));
    fill->setToolTip(
        tr("Reciprocating: piston, pin, rings, small end; rotating: big end and shells, by the "
           "nominal masses of the weigh-in sheet."));
    fill->setMinimumHeight(Theme::withText(fieldHeight));
    current()->addWide(fill);
    connect(fill, &QPushButton::clicked, model_, &V8PlugsModel::fillNominalMasses);
    follow([this, fill] { fill->setEnabled(model_->canFillNominalMasses()); });
    addOwnEngineButtons();
    // Below the fields: they must not move while one types.
    QLabel* note = captionLabel({}, this);
    note->setObjectName(QStringLiteral("engine_note"));
    current()->addWide(note);
    follow([this, note] {
        QStringList said{model_->engineNote(), model_->carriedOver()};
        said.removeAll(QString());
        note->setText(said.join(QLatin1Char('\n')));
        note->setVisible(!said.isEmpty());
    });
    finish();
}

void EngineSheet::addPlugs(const QString& label, const QString& name, const QString& hint,
                           EngineGroup group, bool Engine::*member) {
    QCheckBox* there = ordered(box(
        name, label, hint, [this, member] { return model_->input().engine.*member; },
        [this, step = QString(label).remove(QLatin1Char('&')), group](bool on) {
            model_->setPlugs(step, group, on);
        }));
    there->setFont(Theme::font(Theme::baseSize, true));
    there->setMinimumHeight(Theme::withText(fieldHeight - 6));
    addValues(group);
}

void EngineSheet::addValues(EngineGroup group) {
    for (const EngineField& each : engine_fields()) {
        if (each.group == group) {
            number(("/engine/" + std::string(each.field.key)).c_str());
        }
    }
}

void EngineSheet::addOwnEngineButtons() {
    auto* buttons = new QWidget(this);
    QHBoxLayout* row = rowIn(buttons, -1);
    const auto button = [&](const QString& name, const QString& label) {
        auto* made = new QPushButton(label, this);
        made->setObjectName(name);
        made->setMinimumHeight(Theme::withText(fieldHeight));
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
    current()->addWide(buttons);
}

QString EngineSheet::presentName() const {
    return model_->input().preset.empty() ? QString::fromStdString(model_->input().engine.name)
                                          : QString();
}

/// Asks for a name; empty where the user does not want to go on.
QString EngineSheet::askName(const QString& title, const QString& suggestion) {
    const auto name = ravnoves::askName(this, title, tr("Name of the engine:"), suggestion);
    if (name && name->trimmed().isEmpty()) {
        QMessageBox::warning(this, title, tr("The engine needs a name."));
    }
    return name.value_or(QString()).trimmed();
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
