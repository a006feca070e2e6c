#include "v8-plugs/weigh_in_sheet.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "theme/theme.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/result_table.h"
#include "v8-plugs/model/v8_names.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int cellHeight = 30;  // all of the sheet has to be seen on 800 lines

QString keyOf(Part part) {
    const std::string_view key = part_key(part);
    return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

}  // namespace

WeighInSheet::WeighInSheet(V8PlugsModel* model, QWidget* parent) : SheetForm(model, parent) {
    column_->setSpacing(Theme::space);

    auto* head = new QGridLayout;
    head->setHorizontalSpacing(Theme::space);
    use_ = new QCheckBox(tr("Take the mass changes &from this sheet"), this);
    use_->setObjectName(QStringLiteral("changes_from_weigh_in"));
    use_->setToolTip(tr("Off: the changes typed on the sheet “Job” count."));
    head->addWidget(use_, 0, 0, 1, 2);
    auto* numberingLabel = new QLabel(tr("C&ylinders of a crankpin"), this);
    numbering_ = new QComboBox(this);
    numbering_->setObjectName(QStringLiteral("cylinder_numbering"));
    numbering_->addItems({tr("1 and 5, 2 and 6, … (bank by bank)"), tr("1 and 2, 3 and 4, …")});
    numbering_->setToolTip(tr("Which two cylinders share a crankpin."));
    numbering_->setMinimumHeight(cellHeight);
    numbering_->setAccessibleName(tr("Cylinders of a crankpin"));
    numberingLabel->setBuddy(numbering_);
    head->addWidget(numberingLabel, 1, 0);
    head->addWidget(numbering_, 1, 1);
    head->setColumnStretch(1, 1);
    column_->addLayout(head);
    order_ << use_ << numbering_;

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(Theme::gap);
    grid->setVerticalSpacing(2);
    const QStringList rows{tr("nominal, g"), tr("permitted spread, g")};
    constexpr int firstCylinder = 3;
    constexpr int meanRow = firstCylinder + cylinder_count;
    const auto rowLabel = [&](int row, const QString& text) {
        auto* label = new QLabel(text, this);
        label->setFont(Theme::font(row < firstCylinder || row >= meanRow ? Theme::smallSize
                                                                         : Theme::titleSize));
        label->setWordWrap(true);
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(label, row, 0);
    };
    rowLabel(1, rows.at(0));
    rowLabel(2, rows.at(1));
    for (int cylinder = 0; cylinder < cylinder_count; ++cylinder) {
        rowLabel(firstCylinder + cylinder, QString::number(cylinder + 1));
    }
    rowLabel(meanRow, tr("mean, g"));
    rowLabel(meanRow + 1, tr("to nominal, g"));
    rowLabel(meanRow + 2, tr("spread, g"));
    grid->setColumnMinimumWidth(0, 58);

    const Words words;
    FieldSpec nominalSpec = part_mass_field;
    int place = 1;
    for (const Part part : all_parts) {
        const QString name = v8_text::partName(words, part);
        auto* heading = new QLabel(name, this);
        heading->setFont(Theme::font(Theme::smallSize, true));
        heading->setWordWrap(true);
        heading->setAlignment(Qt::AlignCenter);
        grid->addWidget(heading, 0, place);
        grid->setColumnStretch(place, 1);
        Column fields{};
        fields.nominal =
            addField(QStringLiteral("nominal_") + keyOf(part), tr("%1, nominal mass, g").arg(name),
                     nominalSpec, tr("%1: mass by the drawing.").arg(name));
        fields.permitted = addField(QStringLiteral("spread_") + keyOf(part),
                                    tr("%1, permitted spread, g").arg(name), permitted_spread_field,
                                    tr("%1: heaviest less lightest that the works manual permits. "
                                       "Empty: no limit.")
                                        .arg(name));
        grid->addWidget(fields.nominal, 1, place);
        grid->addWidget(fields.permitted, 2, place);
        for (int cylinder = 0; cylinder < cylinder_count; ++cylinder) {
            NumberField* field =
                addField(QStringLiteral("mass_%1_%2").arg(keyOf(part)).arg(cylinder + 1),
                         tr("%1 of cylinder %2, g").arg(name).arg(cylinder + 1), part_mass_field,
                         tr("%1 of cylinder %2 as the scale says.").arg(name).arg(cylinder + 1));
            fields.mass[static_cast<std::size_t>(cylinder)] = field;
            grid->addWidget(field, firstCylinder + cylinder, place);
            connect(field, &NumberField::valueEdited, this,
                    [this, part, cylinder, name](std::optional<double> value) {
                        model_->edit(
                            tr("%1 %2").arg(name).arg(cylinder + 1), [&](Input& input) {
                                if (!input.weigh_in) {
                                    input.weigh_in.emplace();
                                }
                                (*input.weigh_in)[part].mass[static_cast<std::size_t>(cylinder)] =
                                    value ? std::optional(*value * 1e-3) : std::nullopt;
                            });
                    });
        }
        const auto bindColumn = [&](NumberField* field, std::optional<double> PartColumn::*member,
                                    const QString& step) {
            connect(field, &NumberField::valueEdited, this,
                    [this, part, member, step](std::optional<double> value) {
                        model_->edit(step, [&](Input& input) {
                            if (!input.weigh_in) {
                                input.weigh_in.emplace();
                            }
                            (*input.weigh_in)[part].*member =
                                value ? std::optional(*value * 1e-3) : std::nullopt;
                        });
                    });
        };
        bindColumn(fields.nominal, &PartColumn::nominal, tr("%1, nominal").arg(name));
        bindColumn(fields.permitted, &PartColumn::permitted_spread, tr("%1, spread").arg(name));
        const auto note = [&](int row) {
            auto* label = new QLabel(this);
            label->setFont(Theme::font(Theme::baseSize));
            label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
            grid->addWidget(label, row, place);
            return label;
        };
        fields.mean = note(meanRow);
        fields.deviation = note(meanRow + 1);
        fields.spread = note(meanRow + 2);
        columns_.push_back(fields);
        ++place;
    }
    column_->addLayout(grid);

    trouble_ = new QLabel(this);
    trouble_->setWordWrap(true);
    trouble_->hide();
    column_->addWidget(trouble_);
    summary_ = new QLabel(this);
    summary_->setWordWrap(true);
    summary_->setFont(Theme::font(Theme::baseSize, true));
    move_ = new QPushButton(tr("&Move them here"), this);
    move_->setObjectName(QStringLiteral("move_parts"));
    move_->setToolTip(tr("The weights change places on this sheet as the parts do."));
    move_->setMinimumHeight(cellHeight);
    connect(move_, &QPushButton::clicked, this, [this] {
        const auto assignment = model_->solution().assignment;
        if (assignment) {
            model_->edit(tr("Move parts"), [&](Input& input) {
                input.weigh_in = reassigned(input.weigh_in.value(), *assignment);
            });
        }
    });
    auto* found = new QHBoxLayout;
    found->addWidget(summary_, 1);
    found->addWidget(move_, 0, Qt::AlignTop);
    column_->addLayout(found);
    crankpins_ = new ResultTable(this);
    crankpins_->setAccessibleName(tr("Excess on each crankpin, as weighed and after moving"));
    crankpins_->setColumns(model_->crankpinColumns());
    crankpins_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column_->addWidget(crankpins_);
    assignment_ = new ResultTable(this);
    assignment_->setAccessibleName(tr("Which set goes to which cylinder"));
    assignment_->setColumns(model_->assignmentColumns());
    assignment_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column_->addWidget(assignment_);
    column_->addStretch();

    connect(use_, &QCheckBox::toggled, this, [this](bool on) {
        model_->edit(tr("Source of the mass changes"), [&](Input& input) {
            if (on && !input.weigh_in) {
                input.weigh_in.emplace();
            }
            input.changes_from_weigh_in = on;
        });
    });
    connect(numbering_, &QComboBox::activated, this, [this](int which) {
        model_->edit(tr("Cylinders of a crankpin"), [&](Input& input) {
            if (!input.weigh_in) {
                input.weigh_in.emplace();
            }
            input.weigh_in->numbering =
                which == 0 ? CylinderNumbering::bank_by_bank : CylinderNumbering::alternating;
        });
    });
    connect(&Theme::instance(), &Theme::changed, this, &WeighInSheet::showInput);
    follow([this] { showInput(); });
}

NumberField* WeighInSheet::addField(const QString& name, const QString& accessible,
                                    const FieldSpec& spec, const QString& hint) {
    auto* field = new NumberField(spec, this);
    field->setObjectName(name);
    field->setOptional(true);
    field->setAccessibleName(accessible);
    field->setHint(hint);
    field->setMinimumWidth(44);
    field->setMinimumHeight(cellHeight);
    field->setFont(Theme::font(Theme::titleSize));
    connect(field, &NumberField::troubleChanged, this, [this, accessible](const QString& trouble) {
        trouble_->setText(trouble.isEmpty() ? QString()
                                            : accessible + QStringLiteral(": ") + trouble);
        trouble_->setVisible(!trouble.isEmpty());
        colourText(trouble_, Theme::instance().error());
    });
    order_ << field;
    return field;
}

void WeighInSheet::showInput() {
    const Input& input = model_->input();
    const QSignalBlocker block(use_);
    use_->setChecked(input.changes_from_weigh_in);
    numbering_->setCurrentIndex(
        input.weigh_in && input.weigh_in->numbering == CylinderNumbering::alternating ? 1 : 0);
    static const PartColumn empty;
    const auto shown = [](const std::optional<double>& mass) {
        return mass ? std::optional(in_unit(*mass, part_mass_field)) : std::nullopt;
    };
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Part part = all_parts[i];
        const PartColumn& column = input.weigh_in ? (*input.weigh_in)[part] : empty;
        Column& fields = columns_[i];
        fields.nominal->setValue(shown(column.nominal));
        fields.permitted->setValue(shown(column.permitted_spread));
        for (std::size_t cylinder = 0; cylinder < column.mass.size(); ++cylinder) {
            fields.mass[cylinder]->setValue(shown(column.mass[cylinder]));
        }
        const auto note = model_->columnNote(part);
        fields.mean->setText(note.mean);
        fields.spread->setText(note.tooWide ? note.spread + QStringLiteral(" !") : note.spread);
        fields.spread->setToolTip(note.toolTip);
        fields.mean->setToolTip(note.toolTip);
        fields.deviation->setText(note.deviation);
        fields.deviation->setToolTip(note.toolTip);
        const Theme& theme = Theme::instance();
        colourText(fields.spread, note.tooWide ? theme.error() : theme.text());
    }
    QStringList summary = model_->weighInGaps();
    summary << model_->assignmentText();
    summary.removeAll(QString());
    summary_->setText(summary.join(QLatin1Char('\n')));
    move_->setVisible(model_->solution().assignment && model_->solution().assignment->moved > 0);
    const auto assignment = model_->assignmentRows();
    assignment_->setRows(assignment);
    assignment_->setVisible(!assignment.isEmpty());
    crankpins_->setRows(model_->crankpinRows());
    crankpins_->setVisible(!assignment.isEmpty());
}

}  // namespace ravnoves
