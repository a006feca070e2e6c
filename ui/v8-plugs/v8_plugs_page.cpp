#include "v8-plugs/v8_plugs_page.h"

#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "case-file/input_error.h"
#include "plot/plot_view.h"
#include "shell/language.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "v8-plugs/checked_field.h"
#include "v8-plugs/job_card.h"
#include "v8-plugs/journal_dialog.h"
#include "v8-plugs/plug_view.h"
#include "v8-plugs/v8_plugs_view_model.h"
#include "v8-plugs/v8_text.h"
#include "v8-plugs/weigh_in_sheet.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr double gram = 1e-3;
constexpr double millimetre = 1e-3;
constexpr int fieldHeight = 34;  // a target that a thumb finds
constexpr int sheetWidth = 470;
constexpr int textWidth = 290;

/// Large enough to be read at arm's length and hit with a gloved finger.
void enlarge(QWidget* field) {
    field->setMinimumHeight(fieldHeight);
    field->setFont(Theme::font(Theme::titleSize + 1));
}

void colourText(QLabel* label, const QColor& colour) {
    QPalette palette = label->palette();
    palette.setColor(QPalette::WindowText, colour);
    label->setPalette(palette);
}

QLabel* wrapped(QWidget* parent, int size, bool bold = false) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setFont(Theme::font(size, bold));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

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
    const auto tr = [](const char* text) {
        return QCoreApplication::translate("ravnoves::V8PlugsPage", text);
    };
    if (key == "crank_radius_mm") {
        return tr(QT_TRANSLATE_NOOP("ravnoves::V8PlugsPage", "Half the stroke."));
    }
    if (key == "plug_radius_mm") {
        return tr(QT_TRANSLATE_NOOP("ravnoves::V8PlugsPage",
                                    "From the crank axis to the centre of mass of today's plug."));
    }
    if (key == "new_plug_radius_mm") {
        return tr(QT_TRANSLATE_NOOP(
            "ravnoves::V8PlugsPage",
            "From the crank axis to the centre of mass of a plug of the new design."));
    }
    if (key == "steel_plug_mass_g" || key == "aluminium_plug_mass_g") {
        return tr(QT_TRANSLATE_NOOP("ravnoves::V8PlugsPage",
                                    "One plug as the scale says, before it is machined."));
    }
    if (key == "new_steel_plug_mass_g" || key == "new_aluminium_plug_mass_g") {
        return tr(QT_TRANSLATE_NOOP(
            "ravnoves::V8PlugsPage",
            "One plug of the new design, for which the crankshaft's counterweights are made."));
    }
    if (key == "max_steel_reduction_g" || key == "max_aluminium_reduction_g") {
        return tr(QT_TRANSLATE_NOOP("ravnoves::V8PlugsPage",
                                    "The most that the strength of its walls allows to take off "
                                    "one plug."));
    }
    if (key == "rod_coefficient") {
        return tr(QT_TRANSLATE_NOOP(
            "ravnoves::V8PlugsPage",
            "Design coefficient of the rod: a heavier big end counts (2 + k) times."));
    }
    if (key == "oil_mass_g") {
        return tr(QT_TRANSLATE_NOOP("ravnoves::V8PlugsPage",
                                    "Oil in the sludge trap of one crankpin of a running engine."));
    }
    if (key == "oil_coefficient") {
        return tr(QT_TRANSLATE_NOOP(
            "ravnoves::V8PlugsPage",
            "What the oil counts for on the crankpin's axis, from its centre of mass."));
    }
    if (key == "reciprocating_mass_g") {
        return tr(QT_TRANSLATE_NOOP("ravnoves::V8PlugsPage",
                                    "Nominal mass of piston, pin, rings and the small-end share of "
                                    "the rod, one cylinder."));
    }
    return tr(QT_TRANSLATE_NOOP("ravnoves::V8PlugsPage",
                                "Nominal mass of the rod's big end and its shells, one cylinder."));
}

}  // namespace

V8PlugsPage::V8PlugsPage(QWidget* parent) : V8PlugsPage(Journal::defaultPath(), parent) {}

V8PlugsPage::V8PlugsPage(const QString& journalPath, QWidget* parent)
    : ScenePage(parent), model_(new V8PlugsViewModel(journalPath, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    column->setSpacing(Theme::space);

    banner_ = new Panel(this);
    auto* bannerRow = new QHBoxLayout(banner_);
    bannerRow->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    bannerText_ = wrapped(banner_, Theme::baseSize, true);
    bannerText_->setObjectName(QStringLiteral("banner"));
    bannerRow->addWidget(bannerText_, 1);
    const auto bannerButton = [&](const QString& name, const QString& text) {
        auto* button = new QPushButton(text, banner_);
        button->setObjectName(name);
        button->setMinimumHeight(fieldHeight);
        bannerRow->addWidget(button);
        return button;
    };
    bannerContinue_ = bannerButton(QStringLiteral("draft_continue"), tr("Continue it"));
    bannerDiscard_ = bannerButton(QStringLiteral("draft_discard"), tr("Throw it away"));
    bannerClose_ = bannerButton(QStringLiteral("banner_close"), tr("Understood"));
    banner_->hide();
    column->addWidget(banner_);

    auto* row = new QHBoxLayout;
    row->setSpacing(Theme::space);
    row->addWidget(buildSheets());
    row->addWidget(buildAnswer(), 1);
    column->addLayout(row, 1);
    buildActions();

    connect(bannerContinue_, &QPushButton::clicked, this, [this] {
        if (crashed_.isEmpty() || !leaveJob()) {
            return;
        }
        const QString trouble = model_->restoreDraft(crashed_.constFirst());
        if (trouble.isEmpty()) {
            Q_EMIT status(tr("The unfinished job is on the sheet again."));
            crashed_.removeFirst();
        } else {
            QMessageBox::warning(this, tr("Unfinished job"), trouble);
        }
        showBanner();
    });
    connect(bannerDiscard_, &QPushButton::clicked, this, [this] {
        if (!crashed_.isEmpty()) {
            model_->discardDraft(crashed_.takeFirst().session);
        }
        showBanner();
    });
    connect(bannerClose_, &QPushButton::clicked, this, [this] { banner_->hide(); });
    connect(model_, &V8PlugsViewModel::journalTroubleChanged, this, &V8PlugsPage::showBanner);
    connect(model_, &V8PlugsViewModel::enginesChanged, this, &V8PlugsPage::showEngines);
    connect(model_, &V8PlugsViewModel::sheetChosen, sheets_, &QTabWidget::setCurrentIndex);
    connect(model_, &SceneViewModel::changed, this, &V8PlugsPage::showInput);
    connect(model_, &SceneViewModel::changed, this, &V8PlugsPage::showAnswer);
    connect(&Theme::instance(), &Theme::changed, this, &V8PlugsPage::showAnswer);
    // What was typed is in the draft when the next field is entered.
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* old, QWidget* /*now*/) {
        if (old != nullptr && isAncestorOf(old)) {
            model_->flushDraft();
        }
    });
    showEngines();
    showInput();
    showAnswer();
}

SceneViewModel* V8PlugsPage::model() {
    return model_;
}

QList<QAction*> V8PlugsPage::sceneActions() {
    return actions_;
}

// -------------------------------------------------------------------------------------- sheets

NumberField* V8PlugsPage::number(FormSection* section, const QString& label, const FieldSpec& spec,
                                 const QString& hint, std::function<std::optional<double>()> read,
                                 std::function<void(CaseInput&, std::optional<double>)> write) {
    NumberField* field =
        section->addNumber(label, spec, hint, v8_text::unitName(Words(), spec.unit));
    field->setOptional(true);
    field->setMaximumWidth(140);
    enlarge(field);
    QString step = label;
    step.remove(QLatin1Char('&'));
    connect(field, &NumberField::valueEdited, this,
            [this, step, write = std::move(write)](std::optional<double> value) {
                model_->edit(step, [&](CaseInput& input) { write(input, value); });
            });
    readers_.emplace_back([field, read = std::move(read)] { field->setValue(read()); });
    return field;
}

QLineEdit* V8PlugsPage::text(FormSection* section, const QString& label, const QString& name,
                             std::string JobHeader::*member, const QString& hint) {
    auto* field = new QLineEdit(section);
    field->setObjectName(name);
    field->setMaxLength(200);
    field->setMinimumWidth(textWidth);
    enlarge(field);
    section->addWidget(label, field, {}, hint);
    QString step = label;
    step.remove(QLatin1Char('&'));
    connect(field, &QLineEdit::textEdited, this, [this, step, member](const QString& typed) {
        model_->edit(step, [&](CaseInput& input) { input.job.*member = typed.toStdString(); });
    });
    readers_.emplace_back([this, field, member] {
        const QString value = QString::fromStdString(model_->input().job.*member);
        if (field->text() != value) {
            field->setText(value);
        }
    });
    return field;
}

QWidget* V8PlugsPage::addSheet(QWidget* form, const QString& title, const QList<QWidget*>& order) {
    auto* scroll = new QScrollArea(sheets_);
    scroll->setWidget(form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const int sheet = sheets_->addTab(scroll, title);
    order_[sheet] = order;
    for (QWidget* field : order) {
        field->installEventFilter(this);
    }
    for (qsizetype i = 1; i < order.size(); ++i) {
        QWidget::setTabOrder(order.at(i - 1), order.at(i));
    }
    return scroll;
}

QWidget* V8PlugsPage::buildSheets() {
    sheets_ = new QTabWidget(this);
    sheets_->setDocumentMode(true);
    sheets_->setFixedWidth(sheetWidth);
    buildJobSheet();
    buildEngineSheet();
    weighIn_ = new WeighInSheet(model_, this);
    addSheet(weighIn_, tr("&3 Weigh-in"), weighIn_->order());
    buildPlugSheet();
    buildMachineSheet();
    return sheets_;
}

QWidget* V8PlugsPage::buildJobSheet() {
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);
    QList<QWidget*> order;

    auto* job = new FormSection(tr("Job"), form);
    order << text(job, tr("Engine &number"), QStringLiteral("engine_number"),
                  &JobHeader::engine_number, tr("The journal finds the job by it."))
          << text(job, tr("Crankshaft num&ber"), QStringLiteral("crankshaft_number"),
                  &JobHeader::crankshaft_number, tr("As stamped on the crankshaft."))
          << text(job, tr("C&ustomer"), QStringLiteral("customer"), &JobHeader::customer,
                  tr("Who brought the engine; the journal finds the job by it."));
    auto* date = new CheckedField(
        [this](const QString& typed) {
            return readDay(typed).isValid()
                       ? QString()
                       : tr("“%1” is no date; write it like 2024-05-31.").arg(typed);
        },
        job);
    date->setObjectName(QStringLiteral("date"));
    enlarge(date);
    job->addWidget(tr("&Date"), date, {}, tr("Year-month-day or day.month.year."));
    auto* dateTrouble = wrapped(job, Theme::smallSize);
    dateTrouble->hide();
    job->addWide(dateTrouble);
    connect(date, &CheckedField::troubleChanged, dateTrouble, [dateTrouble](const QString& words) {
        dateTrouble->setText(words);
        dateTrouble->setVisible(!words.isEmpty());
        colourText(dateTrouble, Theme::instance().error());
    });
    connect(date, &CheckedField::valueEdited, this, [this](const QString& typed) {
        model_->edit(tr("Date"), [&](CaseInput& input) {
            input.job.date = readDay(typed).toString(Qt::ISODate).toStdString();
        });
    });
    readers_.emplace_back([this, date] {
        const QString value = QString::fromStdString(model_->input().job.date);
        if (readDay(date->text()).toString(Qt::ISODate) != value) {
            date->setValue(value);
        }
    });
    order << date
          << text(job, tr("&Technician"), QStringLiteral("technician"), &JobHeader::technician,
                  tr("Who does the work."));
    column->addWidget(job);

    auto* work = new FormSection(tr("Work"), form);
    engine_ = new QComboBox(work);
    engine_->setObjectName(QStringLiteral("engine"));
    enlarge(engine_);
    work->addWidget(tr("&Engine"), engine_, {},
                    tr("Engines of the paper by displacement, then your own."));
    connect(engine_, &QComboBox::activated, this, [this](int place) {
        model_->chooseEngine(place);
        showEngines();
    });
    auto* process = new QComboBox(work);
    process->setObjectName(QStringLiteral("process"));
    const Words words;
    process->addItems({v8_text::processName(words, Process::repair),
                       v8_text::processName(words, Process::manufacture)});
    enlarge(process);
    work->addWidget(tr("&Work"), process, {},
                    tr("In manufacture repair pistons and repair shells are not counted."));
    connect(process, &QComboBox::activated, this, [this](int which) {
        model_->edit(tr("Work"), [&](CaseInput& input) {
            input.process = which == 0 ? Process::repair : Process::manufacture;
        });
    });
    crankshaft_ = new QComboBox(work);
    crankshaft_->setObjectName(QStringLiteral("crankshaft"));
    crankshaft_->addItems({v8_text::crankshaftName(words, Crankshaft::standard),
                           v8_text::crankshaftName(words, Crankshaft::new_plugs)});
    enlarge(crankshaft_);
    work->addWidget(tr("Cran&kshaft"), crankshaft_, {},
                    tr("Which plugs the counterweights of the crankshaft were made for."));
    connect(crankshaft_, &QComboBox::activated, this, [this](int which) {
        model_->edit(tr("Crankshaft"), [&](CaseInput& input) {
            input.crankshaft = which == 0 ? Crankshaft::standard : Crankshaft::new_plugs;
        });
    });
    readers_.emplace_back([this, process] {
        process->setCurrentIndex(model_->input().process == Process::repair ? 0 : 1);
        crankshaft_->setCurrentIndex(model_->input().crankshaft == Crankshaft::standard ? 0 : 1);
        crankshaft_->setEnabled(model_->input().engine.has_new_plug);
    });
    order << engine_ << process << crankshaft_;
    column->addWidget(work);

    auto* changes = new FormSection(tr("Heavier than nominal by (negative: lighter)"), form);
    const std::array<QString, 4> labels{tr("&Improved piston"), tr("&Rod big end"),
                                        tr("Re&pair piston and rings"), tr("Repair &shells")};
    const std::array<QString, 4> hints{
        tr("Δm_pi: one piston against nominal."), tr("Δm_be: one big end against nominal."),
        tr("Δm_rp: one repair piston with its rings against nominal."),
        tr("Δm_sh: the repair shells of one crankpin against nominal.")};
    for (std::size_t i = 0; i < mass_change_fields().size(); ++i) {
        const MassChangeField& field = mass_change_fields()[i];
        NumberField* made = number(
            changes, labels[i], field.spec, hints[i],
            [this, field]() -> std::optional<double> {
                const double value = model_->solution().changes.*field.member;
                return in_unit(value, field.spec);
            },
            [field](CaseInput& input, std::optional<double> value) {
                input.typed_changes.*field.member = value.value_or(0.0) * field.spec.to_si;
            });
        made->setPlaceholderText(QStringLiteral("0"));
        readers_.emplace_back([this, made, field] {
            made->setEnabled(!model_->input().changes_from_weigh_in &&
                             (!field.repair_only || model_->input().process == Process::repair));
        });
        order << made;
    }
    auto* source = wrapped(changes, Theme::smallSize);
    changes->addWide(source);
    readers_.emplace_back([this, source] {
        source->setText(tr("Taken from the weigh-in sheet."));
        source->setVisible(model_->input().changes_from_weigh_in);
    });
    order << number(
        changes, tr("Residual unbalance &allowed"), tolerance_field,
        tr("In each correction plane. The paper accepts 5 g·mm."),
        [this] { return in_unit(model_->input().tolerance, tolerance_field); },
        [](CaseInput& input, std::optional<double> value) {
            input.tolerance = value ? *value * tolerance_field.to_si : default_tolerance;
        });
    column->addWidget(changes);
    column->addStretch();
    return addSheet(form, tr("&1 Job"), order);
}

QWidget* V8PlugsPage::buildEngineSheet() {
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);
    QList<QWidget*> order;
    const Words words;

    engineNote_ = captionLabel({}, form);
    column->addWidget(engineNote_);

    auto* basic = new FormSection(tr("Crankshaft and today's plugs"), form);
    auto* aluminium = new FormSection({}, form);
    auto* newDesign = new FormSection({}, form);
    auto* bob = new FormSection(tr("Nominal masses, for the bob weight"), form);
    const auto flag = [&](const QString& label, const QString& name, EngineGroup group,
                          bool Engine::*member) {
        auto* box = new QCheckBox(label, form);
        box->setObjectName(name);
        box->setFont(Theme::font(Theme::baseSize, true));
        box->setMinimumHeight(fieldHeight - 6);
        QString step = label;
        step.remove(QLatin1Char('&'));
        connect(box, &QCheckBox::toggled, this, [this, step, group, member](bool on) {
            model_->edit(step, [&](CaseInput& input) {
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
        readers_.emplace_back([this, box, member] {
            const QSignalBlocker block(box);
            box->setChecked(model_->input().engine.*member);
        });
        return box;
    };
    aluminium_ = flag(tr("There are &aluminium plugs"), QStringLiteral("has_aluminium_plug"),
                      EngineGroup::aluminium_plug, &Engine::has_aluminium_plug);
    newDesign_ = flag(tr("There are plugs of the new &design"), QStringLiteral("has_new_plug"),
                      EngineGroup::new_plug, &Engine::has_new_plug);
    const auto sectionOf = [&](EngineGroup group) {
        switch (group) {
            case EngineGroup::aluminium_plug:
                return aluminium;
            case EngineGroup::new_plug:
                return newDesign;
            case EngineGroup::bob_weight:
                return bob;
            case EngineGroup::basic:
                break;
        }
        return basic;
    };
    QString mnemonics = QStringLiteral("adkv");  // of the check boxes and buttons
    QMap<int, QList<QWidget*>> groups;
    for (const EngineField& field : engine_fields()) {
        NumberField* made = number(
            sectionOf(field.group),
            withMnemonic(v8_text::fieldName(words, field.spec.key), mnemonics), field.spec,
            hintOf(field.spec.key),
            [this, field]() -> std::optional<double> {
                const auto& value = model_->input().engine.*field.member;
                return value ? std::optional(in_unit(*value, field.spec)) : std::nullopt;
            },
            [field](CaseInput& input, std::optional<double> value) {
                input.engine.*field.member =
                    value ? std::optional(*value * field.spec.to_si) : std::nullopt;
            });
        made->setPlaceholderText(tr("needed"));
        readers_.emplace_back([this, made, field] {
            made->setEnabled(!is_inapplicable(model_->input().engine, field.group));
        });
        groups[static_cast<int>(field.group)] << made;
    }
    column->addWidget(basic);
    column->addWidget(aluminium_);
    column->addWidget(aluminium);
    column->addWidget(newDesign_);
    column->addWidget(newDesign);
    column->addWidget(bob);
    order << groups[static_cast<int>(EngineGroup::basic)] << aluminium_
          << groups[static_cast<int>(EngineGroup::aluminium_plug)] << newDesign_
          << groups[static_cast<int>(EngineGroup::new_plug)]
          << groups[static_cast<int>(EngineGroup::bob_weight)];

    auto* own = new QHBoxLayout;
    auto* save = new QPushButton(tr("&Keep as own engine…"), form);
    save->setObjectName(QStringLiteral("save_engine"));
    save->setMinimumHeight(fieldHeight);
    connect(save, &QPushButton::clicked, this, &V8PlugsPage::saveEngine);
    removeEngine_ = new QPushButton(tr("Remo&ve own engine"), form);
    removeEngine_->setObjectName(QStringLiteral("remove_engine"));
    removeEngine_->setMinimumHeight(fieldHeight);
    connect(removeEngine_, &QPushButton::clicked, this, [this] {
        const QString name = QString::fromStdString(model_->input().engine.name);
        if (QMessageBox::question(this, tr("Remove engine"),
                                  tr("Remove “%1” from your own engines?").arg(name)) ==
            QMessageBox::Yes) {
            const QString trouble = model_->removeEngine(name);
            if (!trouble.isEmpty()) {
                QMessageBox::warning(this, tr("Remove engine"), trouble);
            }
        }
    });
    own->addWidget(save);
    own->addWidget(removeEngine_);
    own->addStretch();
    column->addLayout(own);
    column->addStretch();
    return addSheet(form, tr("&2 Engine"), order);
}

QWidget* V8PlugsPage::buildPlugSheet() {
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);
    QList<QWidget*> order;

    auto* plug = new FormSection(tr("Plug"), form);
    auto* thread = new CheckedField(
        [this](const QString& typed) {
            try {
                parse_thread(typed.toStdString(), {});
                return QString();
            } catch (const InputError&) {
                return tr("“%1” is no metric thread with its pitch, like M22x1.5.").arg(typed);
            }
        },
        plug);
    thread->setObjectName(QStringLiteral("thread"));
    thread->setPlaceholderText(QStringLiteral("M22x1.5"));
    enlarge(thread);
    plug->addWidget(tr("&Thread"), thread, {}, tr("Metric thread with its pitch, like M22x1.5."));
    auto* threadTrouble = wrapped(plug, Theme::smallSize);
    threadTrouble->hide();
    plug->addWide(threadTrouble);
    connect(thread, &CheckedField::troubleChanged, threadTrouble,
            [threadTrouble](const QString& words) {
                threadTrouble->setText(words);
                threadTrouble->setVisible(!words.isEmpty());
                colourText(threadTrouble, Theme::instance().error());
            });
    connect(thread, &CheckedField::valueEdited, this, [this](const QString& typed) {
        model_->edit(tr("Thread"), [&](CaseInput& input) {
            if (!input.plug) {
                input.plug.emplace();
            }
            input.plug->thread = typed.isEmpty()
                                     ? std::nullopt
                                     : std::optional(parse_thread(typed.toStdString(), {}));
        });
    });
    readers_.emplace_back([this, thread] {
        const auto& plug = model_->input().plug;
        const auto& value = plug ? plug->thread : std::nullopt;
        std::optional<Thread> shown;
        try {
            if (!thread->text().trimmed().isEmpty()) {
                shown = parse_thread(thread->text().toStdString(), {});
            }
        } catch (const InputError&) {
        }
        if (shown != value) {
            thread->setValue(value ? QString::fromStdString(thread_name(*value)) : QString());
        }
    });
    order << thread;

    const auto size = [&](FormSection* section, const QString& label, const FieldSpec& spec,
                          std::optional<double> PlugSheet::*member, const QString& hint) {
        order << number(
            section, label, spec, hint,
            [this, spec, member]() -> std::optional<double> {
                const auto& sheet = model_->input().plug;
                if (!sheet) {
                    return std::nullopt;
                }
                const std::optional<double>& held = *sheet.*member;
                return held ? std::optional(in_unit(*held, spec)) : std::nullopt;
            },
            [spec, member](CaseInput& input, std::optional<double> value) {
                if (!input.plug) {
                    input.plug.emplace();
                }
                *input.plug.*member = value ? std::optional(*value * spec.to_si) : std::nullopt;
            });
    };
    size(plug, tr("&Height h"), plug_height_field, &PlugSheet::height, tr("Of the whole plug."));
    size(plug, tr("&Bore diameter"), bore_diameter_field, &PlugSheet::bore_diameter,
         tr("Of the bore that is there. Empty: a solid plug."));
    size(plug, tr("Bore de&pth"), bore_depth_field, &PlugSheet::bore_depth,
         tr("From the outer face. Empty: a solid plug."));
    column->addWidget(plug);
    plugWeight_ = wrapped(form, Theme::baseSize);
    column->addWidget(plugWeight_);

    auto* boring = new FormSection(tr("Boring"), form);
    size(boring, tr("&Cutter diameter"), cutter_diameter_field, &PlugSheet::cutter_diameter,
         tr("Empty: no boring is planned."));
    size(boring, tr("&Wall that must stay"), minimum_wall_field, &PlugSheet::minimum_wall,
         tr("Between the bore and the root of the thread. Empty: no limit."));
    size(boring, tr("B&ottom that must stay"), minimum_bottom_field, &PlugSheet::minimum_bottom,
         tr("Between the bore and the inner face. Empty: no limit."));
    column->addWidget(boring);

    auto* material = new FormSection(tr("Density"), form);
    const auto density = [&](const QString& label, const FieldSpec& spec, double PlugSheet::*member,
                             double usual, const QString& hint) {
        order << number(
            material, label, spec, hint,
            [this, member, usual]() -> std::optional<double> {
                const auto& sheet = model_->input().plug;
                return sheet ? *sheet.*member : usual;
            },
            [member, usual](CaseInput& input, std::optional<double> value) {
                if (!input.plug) {
                    input.plug.emplace();
                }
                *input.plug.*member = value.value_or(usual);
            });
    };
    density(tr("&Steel"), steel_density_field, &PlugSheet::steel_density, steel_density,
            tr("Carbon steel 7850 kg/m³."));
    density(tr("&Aluminium"), aluminium_density_field, &PlugSheet::aluminium_density,
            aluminium_density, tr("Wrought alloys 2640 to 2850 kg/m³."));
    column->addWidget(material);
    column->addStretch();
    return addSheet(form, tr("&4 Plug"), order);
}

QWidget* V8PlugsPage::buildMachineSheet() {
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);
    QList<QWidget*> order;

    auto* limits = new FormSection(tr("Permissible residual unbalance, ISO 21940-11"), form);
    const auto value = [&](FormSection* section, const QString& label, const FieldSpec& spec,
                           std::optional<double> BalancingSheet::*member, const QString& hint) {
        auto* made = number(
            section, label, spec, hint,
            [this, spec, member]() -> std::optional<double> {
                const auto& sheet = model_->input().balancing;
                if (!sheet) {
                    return std::nullopt;
                }
                const std::optional<double>& held = *sheet.*member;
                return held ? std::optional(in_unit(*held, spec)) : std::nullopt;
            },
            [spec, member](CaseInput& input, std::optional<double> typed) {
                if (!input.balancing) {
                    input.balancing.emplace();
                }
                *input.balancing.*member =
                    typed ? std::optional(*typed * spec.to_si) : std::nullopt;
            });
        order << made;
        return made;
    };
    value(limits, tr("&Grade G"), grade_field, &BalancingSheet::grade,
          tr("Balance quality grade. The standard's table has 0.4, 1, 2.5, 6.3, 16, 40, 100, 250, "
             "630, 1600, 4000 mm/s; crankshaft drives of car, truck and locomotive engines G 100, "
             "inherently balanced crankshafts better."));
    value(limits, tr("&Mass of the crankshaft"), rotor_mass_field, &BalancingSheet::rotor_mass,
          tr("As it lies on the machine, with the bob weights."));
    value(limits, tr("Service s&peed"), service_speed_field, &BalancingSheet::service_speed,
          tr("The highest speed in service, not that of the machine."));
    order << number(
        limits, tr("&Share of the front plane"), front_share_field,
        tr("Half for a crankshaft whose mass lies midway between the planes; the standard allows "
           "0.3 to 0.7."),
        [this]() -> std::optional<double> {
            return model_->input().balancing ? model_->input().balancing->front_share : 0.5;
        },
        [](CaseInput& input, std::optional<double> typed) {
            if (!input.balancing) {
                input.balancing.emplace();
            }
            input.balancing->front_share = typed.value_or(0.5);
        });
    column->addWidget(limits);
    iso_ = wrapped(form, Theme::baseSize);
    column->addWidget(iso_);

    auto* readings = new FormSection(tr("What the machine reads"), form);
    value(readings, tr("&Front plane (pulley)"), front_reading_field,
          &BalancingSheet::front_reading, tr("Residual unbalance after correction."));
    value(readings, tr("&Rear plane (flywheel)"), rear_reading_field, &BalancingSheet::rear_reading,
          tr("Residual unbalance after correction."));
    column->addWidget(readings);
    planes_ = new ResultTable(form);
    planes_->setAccessibleName(tr("Correction planes"));
    planes_->setColumns(model_->planeColumns());
    planes_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column->addWidget(planes_);

    auto* notes = new FormSection(tr("Notes on the job card"), form);
    order << text(notes, tr("&Notes"), QStringLiteral("notes"), &JobHeader::notes,
                  tr("Printed on the job card."));
    column->addWidget(notes);
    column->addStretch();
    return addSheet(form, tr("&5 Machine"), order);
}

// -------------------------------------------------------------------------------------- answer

QWidget* V8PlugsPage::buildAnswer() {
    auto* holder = new QWidget(this);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);

    auto* answer = new Panel(holder);
    auto* words = new QVBoxLayout(answer);
    words->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    words->setSpacing(Theme::gap);
    excess_ = wrapped(answer, Theme::baseSize);
    excess_->setObjectName(QStringLiteral("excess"));
    advice_ = wrapped(answer, Theme::displaySize, true);
    advice_->setObjectName(QStringLiteral("advice"));
    boring_ = wrapped(answer, Theme::titleSize);
    boring_->setObjectName(QStringLiteral("boring"));
    hang_ = wrapped(answer, Theme::titleSize, true);
    hang_->setObjectName(QStringLiteral("hang"));
    troubles_ = wrapped(answer, Theme::baseSize);
    troubles_->setObjectName(QStringLiteral("troubles"));
    words->addWidget(advice_);
    words->addWidget(boring_);
    auto* numbers = new QHBoxLayout;
    numbers->addWidget(hang_, 3);
    excess_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    numbers->addWidget(excess_, 2);
    words->addLayout(numbers);
    words->addWidget(troubles_);
    options_ = new ResultTable(answer);
    options_->setAccessibleName(tr("The four options"));
    options_->setColumns(model_->optionColumns());
    words->addWidget(options_);
    column->addWidget(answer);

    auto* lower = new QHBoxLayout;
    lower->setSpacing(Theme::space);
    auto* left = new QVBoxLayout;
    left->setSpacing(Theme::space);
    auto* bob = new Panel(holder);
    auto* bobColumn = new QVBoxLayout(bob);
    bobColumn->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    bobColumn->setSpacing(Theme::gap);
    bobColumn->addWidget(headingLabel(tr("Bob weight on each crankpin"), bob));
    bobWeights_ = new ResultTable(bob);
    bobWeights_->setAccessibleName(tr("Bob weight on each crankpin, line by line"));
    bobWeights_->setColumns(model_->bobWeightColumns());
    bobColumn->addWidget(bobWeights_);
    check_ = captionLabel({}, bob);
    bobColumn->addWidget(check_);
    left->addWidget(bob);
    plug_ = new PlugView(model_, holder);
    left->addWidget(plug_, 1);
    lower->addLayout(left, 7);

    auto* right = new QVBoxLayout;
    right->setSpacing(Theme::space);
    const Words language;
    compensation_ = new PlotView(tr("Excess compensated"), holder);
    compensation_->setAccessibleName(tr("Excess compensated over the lightening of one plug"));
    compensation_->setYAxis(PlotView::Side::Left, {tr("Δm_y, g")});
    for (const OptionId id : all_options) {
        PlotView::CurveStyle style;
        style.name = v8_text::shortOption(language, id);
        style.toolTip = v8_text::optionName(language, id);
        style.colour = static_cast<int>(id);
        style.width = 2.0;
        optionCurves_.push_back(compensation_->addCurve(style));
    }
    right->addWidget(compensation_, 1);

    shift_ = new PlotView(tr("Shift of the plug's centre of mass"), holder);
    shift_->setAccessibleName(tr("Coefficient Δk over the shift Δr for five crank radii"));
    shift_->setXAxis({tr("Δr, mm"), 0.0, 1.4});
    shift_->setYAxis(PlotView::Side::Left, {tr("Δk")});
    for (std::size_t i = 0; i < shift_curves.size(); ++i) {
        PlotView::CurveStyle style;
        style.name = language.plain(shift_curves[i].crank_radius / millimetre, 1);
        style.toolTip =
            tr("r = %1: %2")
                .arg(v8_text::millimetres(language, shift_curves[i].crank_radius, 1),
                     QString::fromUtf8(shift_curves[i].engines.data(),
                                       static_cast<qsizetype>(shift_curves[i].engines.size())));
        style.colour = static_cast<int>(i);
        const int curve = shift_->addCurve(style);
        shift_->setCurve(curve, {0.0, 1.4},
                         {0.0, shift_coefficient(1.4 * millimetre, shift_curves[i].crank_radius)});
    }
    PlotView::CurveStyle own;
    own.name = tr("this engine");
    own.colour = 6;
    own.width = 2.4;
    own.pen = Qt::DashLine;
    own.inLegend = false;
    ownShift_ = shift_->addCurve(own);
    QColor shade = Theme::instance().accent();
    shade.setAlphaF(0.12F);
    shift_->setYRange(PlotView::Side::Left, 0.0, 0.036);
    shift_->setBands(
        {{smallest_shift / millimetre, largest_shift / millimetre, shade, tr("neglected")}});
    right->addWidget(shift_, 1);
    shiftNote_ = captionLabel({}, holder);
    right->addWidget(shiftNote_);
    lower->addLayout(right, 6);
    column->addLayout(lower, 1);
    return holder;
}

void V8PlugsPage::buildActions() {
    const auto add = [this](const QString& name, const QString& icon, const QString& text,
                            const QKeySequence& keys, const QString& tip, auto&& slot) {
        auto* action = new QAction(icon.isEmpty() ? QIcon() : themedIcon(icon), text, this);
        action->setObjectName(name);
        action->setShortcut(keys);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        action->setToolTip(tip +
                           QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText)));
        connect(action, &QAction::triggered, this, slot);
        addAction(action);
        actions_ << action;
        return action;
    };
    add(QStringLiteral("save_job"), QStringLiteral("job-done"), tr("&Save job in the journal"),
        QKeySequence(Qt::Key_F2), tr("Save the job in the journal"), [this] { saveJob(); });
    add(QStringLiteral("new_job"), QStringLiteral("job-new"), tr("&Next job"),
        QKeySequence(Qt::Key_F4), tr("Next job: the engine's values stay, the rest is empty"),
        [this] { newJob(); });
    add(QStringLiteral("show_journal"), QStringLiteral("journal"), tr("&Journal…"),
        QKeySequence(Qt::Key_F3), tr("Find, open and copy jobs"), [this] { showJournal(); });
    actions_ << nullptr;
    add(QStringLiteral("preview_card"), QStringLiteral("preview"), tr("Job card, &preview…"),
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P), tr("Look at the job card"),
        [this] { previewCard(); });
    add(QStringLiteral("print_card"), QStringLiteral("print"), tr("&Print job card…"),
        QKeySequence(Qt::CTRL | Qt::Key_P), tr("Print the job card"), [this] { printCard(); });
    add(QStringLiteral("export_card"), QStringLiteral("pdf"), tr("Job card as P&DF…"),
        QKeySequence(Qt::CTRL | Qt::Key_D), tr("Write the job card as PDF"),
        [this] { exportCard(); });

    auto* language = new QAction(tr("&Language of the job card"), this);
    auto* menu = new QMenu(this);
    auto* group = new QActionGroup(menu);
    std::vector<Language> languages{{QString(), tr("As the program")}};
    for (Language& available : availableLanguages()) {
        languages.push_back(std::move(available));
    }
    for (const Language& each : languages) {
        QAction* choice = menu->addAction(
            each.ownName, this, [this, code = each.code] { model_->setCardLanguage(code); });
        choice->setCheckable(true);
        choice->setChecked(each.code == model_->cardLanguage());
        group->addAction(choice);
    }
    language->setMenu(menu);
    actions_ << language;
}

// ------------------------------------------------------------------------------ showing things

void V8PlugsPage::showEngines() {
    const QSignalBlocker block(engine_);
    const QStringList names = model_->engineNames();
    QStringList shown;
    for (int i = 0; i < engine_->count(); ++i) {
        shown << engine_->itemText(i);
    }
    if (shown != names) {
        engine_->clear();
        engine_->addItems(names);
    }
    engine_->setCurrentIndex(model_->engineIndex());
    engine_->setPlaceholderText(tr("other"));
    removeEngine_->setEnabled(model_->isOwnEngine(model_->engineIndex()));
}

void V8PlugsPage::showInput() {
    for (const auto& reader : readers_) {
        reader();
    }
    showEngines();
    engineNote_->setText(model_->engineNote());
    engineNote_->setVisible(!engineNote_->text().isEmpty());
}

void V8PlugsPage::showAnswer() {
    const auto say = [](QLabel* label, const QString& text) {
        label->setText(text);
        label->setVisible(!text.isEmpty());
    };
    const Theme& theme = Theme::instance();
    say(excess_, model_->excessText());
    say(advice_, model_->adviceText());
    const auto& advice = model_->solution().advice;
    const bool works = v8_text::works(model_->solution());
    // What is still missing is no sentence for the display size.
    advice_->setFont(Theme::font(works ? Theme::displaySize : Theme::titleSize, true));
    colourText(advice_, !advice ? theme.mutedText() : works ? theme.text() : theme.error());
    say(boring_, model_->boringText());
    say(hang_, model_->hangText());
    hang_->setFont(Theme::font(model_->solution().before ? Theme::titleSize : Theme::baseSize,
                               model_->solution().before.has_value()));
    say(troubles_, model_->troubles().join(QLatin1Char('\n')));
    colourText(troubles_, theme.warning());
    options_->setRows(model_->optionRows());
    for (int row = 0; row < options_->rowCount(); ++row) {
        for (int column = 0; column < options_->columnCount(); ++column) {
            options_->setCellToolTip(row, column, model_->optionToolTip(row));
        }
    }
    const auto weights = model_->bobWeightRows();
    bobWeights_->setRows(weights);
    bobWeights_->setVisible(!weights.isEmpty());
    QStringList check{model_->checkText()};
    if (weights.isEmpty()) {
        check = {model_->missingText()};
    }
    check.removeAll(QString());
    say(check_, check.join(QLatin1Char('\n')));
    say(shiftNote_, model_->shiftText());
    plugWeight_->setText(model_->plugWeightText());
    iso_->setText(model_->isoText());
    planes_->setRows(model_->planeRows());
    showPlots();
}

void V8PlugsPage::showPlots() {
    const Solution& solution = model_->solution();
    const Words words;
    double reach = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    std::vector<PlotView::Mark> marks;
    for (const OptionId id : all_options) {
        const auto i = static_cast<std::size_t>(id);
        const auto& option = solution.options[i];
        if (!option) {
            compensation_->setCurve(optionCurves_[i], {}, {});
            continue;
        }
        const double most = option->max_reduction / gram;
        compensation_->setCurve(optionCurves_[i], {0.0, most},
                                {option->constant / gram, option->maximum / gram});
        marks.push_back({most, option->maximum / gram, words.number(option->maximum / gram, 2),
                         static_cast<int>(i)});
        reach = std::max(reach, most);
        lowest = std::min(lowest, option->constant / gram);
        highest = std::max(highest, option->maximum / gram);
    }
    // Where this job stands: its excess, and the point of the chosen option.
    std::vector<PlotView::Line> lines;
    if (solution.unbalanced_mass) {
        lines.push_back({*solution.unbalanced_mass / gram, Qt::Horizontal, 6,
                         tr("today %1").arg(words.number(*solution.unbalanced_mass / gram, 2))});
    }
    if (solution.unbalanced_mass) {
        lowest = std::min(lowest, *solution.unbalanced_mass / gram);
        highest = std::max(highest, *solution.unbalanced_mass / gram);
    }
    if (highest > lowest) {
        compensation_->setYRange(PlotView::Side::Left, lowest, highest + 0.16 * (highest - lowest));
    }
    if (const auto chosen = v8_text::chosenOption(solution)) {
        marks.push_back({chosen->reduction / gram,
                         (chosen->constant + chosen->slope * chosen->reduction) / gram,
                         {},
                         static_cast<int>(chosen->id),
                         PlotView::Side::Left,
                         true});
    }
    const double wanted = reach > 0.0 ? 1.25 * reach : 1.0;
    if (wanted != shownReach_) {
        shownReach_ = wanted;
        compensation_->setXAxis({tr("lightening of one plug Δm, g"), 0.0, wanted});
    }
    compensation_->setLines(std::move(lines));
    compensation_->setMarks(std::move(marks));

    const auto& radius = model_->input().engine.crank_radius;
    const bool listed =
        radius && std::any_of(shift_curves.begin(), shift_curves.end(), [&](const ShiftCurve& c) {
            return std::abs(c.crank_radius - *radius) < 1e-6;
        });
    if (radius) {
        shift_->setCurve(ownShift_, {0.0, 1.4},
                         {0.0, shift_coefficient(1.4 * millimetre, *radius)});
    }
    shift_->setCurveShown(ownShift_, radius.has_value() && !listed);
    std::vector<PlotView::Mark> ends;
    if (radius) {
        for (const double shift : {smallest_shift, largest_shift}) {
            const double k = shift_coefficient(shift, *radius);
            ends.push_back(
                {shift / millimetre, k, words.number(k, 3), 6, PlotView::Side::Left, true});
        }
    }
    shift_->setMarks(std::move(ends));
}

void V8PlugsPage::showBanner() {
    const bool draft = !crashed_.isEmpty();
    const QString trouble = model_->journalTrouble();
    if (draft) {
        const JournalDraft& first = crashed_.constFirst();
        bannerText_->setText(
            tr("The program ended unexpectedly on %1 with an unfinished job (engine number: %2).")
                .arg(QLocale().toString(first.saved.toLocalTime(), QLocale::ShortFormat),
                     first.engineNumber.isEmpty() ? QStringLiteral("–") : first.engineNumber));
    } else {
        bannerText_->setText(trouble);
    }
    bannerContinue_->setVisible(draft);
    bannerDiscard_->setVisible(draft);
    bannerClose_->setVisible(!draft);
    banner_->setVisible(draft || !trouble.isEmpty());
}

QString V8PlugsPage::resultsAsText() const {
    return excess_->text() + QLatin1Char('\n') + advice_->text() + QLatin1Char('\n') +
           options_->asText() + QLatin1Char('\n') + bobWeights_->asText() + QLatin1Char('\n') +
           planes_->asText();
}

QString V8PlugsPage::resultsAsCsv() const {
    return options_->asCsv() + QLatin1Char('\n') + bobWeights_->asCsv() + QLatin1Char('\n') +
           planes_->asCsv();
}

void V8PlugsPage::setActive(bool active) {
    if (!active) {
        model_->flushDraft();
    }
}

void V8PlugsPage::resetZoom() {
    compensation_->resetZoom();
    shift_->resetZoom();
}

// -------------------------------------------------------------------------------- going on

bool V8PlugsPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (enter && key->modifiers().testFlag(Qt::ControlModifier) == false) {
            goOn(static_cast<QWidget*>(watched));
            return true;
        }
    } else if (event->type() == QEvent::Wheel && qobject_cast<QComboBox*>(watched) != nullptr) {
        event->ignore();  // the form scrolls; a choice is not changed by accident
        return true;
    } else if (event->type() == QEvent::FocusIn) {
        auto* field = static_cast<QWidget*>(watched);
        for (QWidget* parent = field->parentWidget(); parent != nullptr;
             parent = parent->parentWidget()) {
            if (auto* scroll = qobject_cast<QScrollArea*>(parent)) {
                scroll->ensureWidgetVisible(field, 0, fieldHeight);
                break;
            }
        }
    }
    return ScenePage::eventFilter(watched, event);
}

void V8PlugsPage::goOn(QWidget* from) {
    for (int sheet = 0; sheet < sheets_->count(); ++sheet) {
        const QList<QWidget*>& order = order_[sheet];
        const qsizetype at = order.indexOf(from);
        if (at < 0) {
            continue;
        }
        for (qsizetype next = at + 1; next < order.size(); ++next) {
            if (order.at(next)->isEnabled() && order.at(next)->isVisibleTo(sheets_)) {
                order.at(next)->setFocus(Qt::TabFocusReason);
                return;
            }
        }
        // The end of the sheet: the next one, and after the last the first.
        const int following = (sheet + 1) % sheets_->count();
        sheets_->setCurrentIndex(following);
        for (QWidget* field : order_[following]) {
            if (field->isEnabled()) {
                field->setFocus(Qt::TabFocusReason);
                return;
            }
        }
    }
}

// ------------------------------------------------------------------------- journal and card

void V8PlugsPage::showEvent(QShowEvent* event) {
    ScenePage::showEvent(event);
    if (!journalTried_) {
        journalTried_ = true;
        // After the first picture of the page: a slow disk must not delay it.
        QTimer::singleShot(0, this, &V8PlugsPage::openJournal);
    }
}

void V8PlugsPage::openJournal() {
    journalTried_ = true;
    model_->openJournal();
    crashed_ = model_->crashedDrafts();
    showBanner();
}

bool V8PlugsPage::leaveJob() {
    if (model_->history()->isClean()) {
        return true;
    }
    const auto answer = QMessageBox::question(
        this, tr("Unsaved job"), tr("Save the job on the sheet in the journal?"),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) {
        bool saved = false;
        const QString text = model_->saveJob(&saved);
        if (!saved) {
            QMessageBox::warning(this, tr("Journal"), text);
        }
        return saved;
    }
    return answer == QMessageBox::Discard;
}

void V8PlugsPage::saveJob() {
    bool saved = false;
    const QString text = model_->saveJob(&saved);
    if (saved) {
        Q_EMIT status(text);
    } else {
        QMessageBox::warning(this, tr("Journal"), text);
    }
}

void V8PlugsPage::newJob() {
    if (leaveJob()) {
        model_->newJob();
        sheets_->setCurrentIndex(0);
        order_[0].constFirst()->setFocus(Qt::TabFocusReason);
    }
}

void V8PlugsPage::showJournal() {
    if (!model_->openJournal()) {
        QMessageBox::warning(this, tr("Journal"), model_->journalTrouble());
        return;
    }
    JournalDialog dialog(model_->journal(), this);
    if (dialog.exec() != QDialog::Accepted || !leaveJob()) {
        return;
    }
    const QString trouble = dialog.choice() == JournalDialog::Choice::Copy
                                ? model_->copyJob(dialog.chosenId())
                                : model_->openJob(dialog.chosenId());
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, tr("Journal"), trouble);
    }
}

void V8PlugsPage::saveEngine() {
    bool ok = false;
    const QString name = QInputDialog::getText(
        this, tr("Keep as own engine"), tr("Name of the engine:"), QLineEdit::Normal,
        model_->input().preset.empty() ? QString::fromStdString(model_->input().engine.name)
                                       : QString(),
        &ok);
    if (!ok) {
        return;
    }
    const QString trouble = model_->saveEngineAs(name);
    if (trouble.isEmpty()) {
        Q_EMIT status(tr("Engine %1 kept.").arg(name.trimmed()));
    } else {
        QMessageBox::warning(this, tr("Keep as own engine"), trouble);
    }
}

void V8PlugsPage::paintCard(QPrinter* printer) {
    if (!JobCard(model_->input(), model_->cardWords()).print(*printer)) {
        QMessageBox::warning(this, tr("Job card"), tr("The printer cannot be used."));
    }
}

void V8PlugsPage::previewCard() {
    QPrinter printer(QPrinter::HighResolution);
    JobCard::setPage(printer);
    QPrintPreviewDialog dialog(&printer, this);
    dialog.setWindowTitle(tr("Job card"));
    dialog.resize(900, 760);
    connect(&dialog, &QPrintPreviewDialog::paintRequested, this, &V8PlugsPage::paintCard);
    dialog.exec();
}

void V8PlugsPage::printCard() {
    QPrinter printer(QPrinter::HighResolution);
    JobCard::setPage(printer);
    QPrintDialog dialog(&printer, this);
    if (dialog.exec() == QDialog::Accepted) {
        paintCard(&printer);
    }
}

QString V8PlugsPage::writeCard(const QString& file) {
    return JobCard(model_->input(), model_->cardWords()).writePdf(file);
}

void V8PlugsPage::exportCard() {
    QString name = QString::fromStdString(model_->input().job.engine_number);
    for (QChar& c : name) {
        if (!c.isLetterOrNumber() && c != QLatin1Char('-')) {
            c = QLatin1Char('_');
        }
    }
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Job card as PDF"),
        (name.isEmpty() ? QStringLiteral("job-card") : name) + QStringLiteral(".pdf"),
        tr("PDF (*.pdf)"));
    if (file.isEmpty()) {
        return;
    }
    const QString trouble = writeCard(file);
    if (trouble.isEmpty()) {
        Q_EMIT status(tr("Written: %1").arg(file));
    } else {
        QMessageBox::warning(this, tr("Job card as PDF"), trouble);
    }
}

}  // namespace ravnoves
