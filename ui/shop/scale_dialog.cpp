#include "shop/scale_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <QtSerialPort/QSerialPortInfo>

#include "shop/model/scale_reader.h"
#include "shop/scale_input.h"
#include "text/number_text.h"
#include "text/preferences.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "widgets/form_section.h"

namespace ravnoves {

using shop::ScaleLine;

namespace {

/// The scale's readability, in the unit of small masses that the user has chosen.
constexpr Field resolutionField{
    .key = "scale_resolution", .unit = units::gram, .range = Range::between(1e-4, 1000)};

}  // namespace

ScaleDialog::ScaleDialog(ScaleReader* reader, QWidget* parent) : QDialog(parent), reader_(reader) {
    setWindowTitle(tr("Scale"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::space);
    auto* rows = new FormSection({}, this);
    column->addWidget(rows);
    buildRows(rows);
    state_ = new QLabel(this);
    state_->setObjectName(QStringLiteral("scale_state"));
    state_->setWordWrap(true);
    state_->setMinimumWidth(Theme::withText(460));
    column->addWidget(state_);
    auto* caption = new QLabel(tr("Lines from the &scale"), this);
    lines_ = new QPlainTextEdit(this);
    lines_->setObjectName(QStringLiteral("scale_lines"));
    lines_->setAccessibleName(tr("Lines from the scale"));
    lines_->setReadOnly(true);
    lines_->setTabChangesFocus(true);
    lines_->setMaximumBlockCount(200);
    lines_->setLineWrapMode(QPlainTextEdit::NoWrap);
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(Theme::font().pixelSize());
    lines_->setFont(fixed);
    lines_->setPlaceholderText(
        tr("Press Print on the scale: its lines and their meaning appear here."));
    lines_->setMinimumHeight(Theme::withText(60));
    caption->setBuddy(lines_);
    column->addWidget(caption);
    column->addWidget(lines_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setIcon({});  // black on black in the dark theme
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    column->addWidget(buttons);

    connect(reader_, &ScaleReader::connectionChanged, this, &ScaleDialog::showConnection);
    connect(reader_, &ScaleReader::lineRead, this, &ScaleDialog::showLine);
    connect(this, &QDialog::finished, parent, [this, before = reader->settings().resolution] {
        if (reader_->settings().resolution != before) {
            Preferences::instance().tell();  // the pages say what it means for them
        }
    });
    showConnection();
}

QComboBox* ScaleDialog::addChoice(FormSection* rows, const char* name, const QString& label,
                                  const QString& hint, const QStringList& choices, int present) {
    auto* box = new QComboBox(this);
    box->setObjectName(QLatin1String(name));
    box->addItems(choices);
    box->setCurrentIndex(present);
    rows->addWidget(label, box, {}, hint);
    connect(box, &QComboBox::activated, this, &ScaleDialog::apply);
    return box;
}

void ScaleDialog::buildRows(FormSection* rows) {
    const ScaleSettings& present = reader_->settings();
    port_ = new QComboBox(this);
    port_->setObjectName(QStringLiteral("scale_port"));
    port_->setEditable(true);
    limitLength(port_->lineEdit(), 1000);
    port_->setInsertPolicy(QComboBox::NoInsert);
    port_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    port_->setMinimumContentsLength(30);
    fillPorts();
    rows->addWidget(tr("&Port"), port_, {},
                    tr("Port of the scale; you can type a path such as /dev/ttyUSB0."));
    connect(port_, &QComboBox::activated, this, &ScaleDialog::apply);
    connect(port_->lineEdit(), &QLineEdit::editingFinished, this, &ScaleDialog::apply);

    QStringList rates;
    for (const int rate : {300, 600, 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200}) {
        rates << QString::number(rate);
    }
    if (!rates.contains(QString::number(present.baud))) {
        rates << QString::number(present.baud);
    }
    baud_ = addChoice(rows, "scale_baud", tr("&Baud rate"),
                      tr("Same setting as in the scale's own menu."), rates,
                      static_cast<int>(rates.indexOf(QString::number(present.baud))));
    parity_ = addChoice(rows, "scale_parity", tr("P&arity"),
                        tr("Same setting as in the scale's own menu."),
                        {tr("none, 8 bits"), tr("even, 7 bits"), tr("odd, 7 bits"),
                         tr("even, 8 bits"), tr("odd, 8 bits")},
                        present.parity);
    unit_ = addChoice(rows, "scale_unit", tr("&Unit of bare numbers"),
                      tr("Unit of lines that contain only a number."),
                      {unitText("g"), unitText("kg"), unitText("oz"), unitText("lb")},
                      present.usualUnit);
    taking_ = addChoice(rows, "scale_taking", tr("&Enter a weight"),
                        tr("Stable weights only. Each is entered in the field with the focus; the "
                           "focus moves to the next field."),
                        {tr("at each line (the scale sends on Print)"),
                         tr("once for each part (the scale sends continuously)")},
                        present.taking);

    resolution_ = new NumberField(resolutionField, this);
    resolution_->setObjectName(QStringLiteral("scale_resolution"));
    resolution_->setOptional(true);
    if (present.resolution > 0.0) {
        resolution_->setValue(from_si(resolutionField, present.resolution));
    }
    const QString hint =
        tr("Smallest step of the display; the uncertainty of masses follows. Also for a keyboard "
           "scale or manual reading.");
    rows->addWidget(tr("&Last digit d, %1").arg(resolution_->unit()), resolution_, {}, hint);
    resolution_->setHint(hint);
    connect(resolution_, &NumberField::valueEdited, this, &ScaleDialog::apply);
}

void ScaleDialog::fillPorts() {
    const QString present = reader_->settings().port;
    port_->addItem(tr("none"), QString());
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
        const QString what = info.description();
        port_->addItem(what.isEmpty() ? info.systemLocation()
                                      : info.systemLocation() + QStringLiteral(" – ") + what,
                       info.systemLocation());
    }
    if (port_->findData(present) < 0) {
        port_->addItem(present, present);
    }
    port_->setCurrentIndex(port_->findData(present));
}

ScaleSettings ScaleDialog::chosen() const {
    ScaleSettings settings;
    const QString typed = port_->currentText().trimmed();
    const int known = port_->findText(typed);
    settings.port = known >= 0 ? port_->itemData(known).toString() : typed;
    settings.baud = baud_->currentText().toInt();
    settings.parity = static_cast<ScaleSettings::Parity>(parity_->currentIndex());
    settings.usualUnit = static_cast<ScaleSettings::UsualUnit>(unit_->currentIndex());
    settings.taking = static_cast<ScaleSettings::Taking>(taking_->currentIndex());
    settings.resolution = resolution_->value().value_or(0.0) * units::gram;
    return settings;
}

void ScaleDialog::apply() {
    const ScaleSettings settings = chosen();
    if (settings != reader_->settings()) {
        settings.save();
        reader_->use(settings);
        showConnection();
    }
}

void ScaleDialog::showConnection() {
    const bool isWanted = !reader_->settings().port.isEmpty();
    const QString trouble = reader_->trouble();
    state_->setText(
        !isWanted ? tr("No scale is connected. A scale that acts as a keyboard needs no settings.")
        : trouble.isEmpty() ? tr("Connected to %1.").arg(reader_->settings().port)
                            : trouble);
    colourText(state_, isWanted && !trouble.isEmpty() ? &Theme::error : &Theme::text);
}

void ScaleDialog::showLine(const QByteArray& raw, const ScaleLine& line) {
    const bool isRejected =
        line.kind == ScaleLine::Kind::garbled && !reader_->rejection().isEmpty();
    const QString meaning = isRejected ? reader_->rejection() : meaningOf(line);
    lines_->appendPlainText(shownLine(raw) + QStringLiteral("  →  ") + meaning);
    // The first weight shows what the last digit is.
    if (line.kind == ScaleLine::Kind::stable && !resolution_->value() &&
        resolution_->text().isEmpty()) {
        resolution_->setValue(from_si(resolutionField, line.last_digit()));
        apply();
    }
}

}  // namespace ravnoves
