#include "balance-shaft/relieved_shaft_view.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/scene.h"
#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

using balance_shaft::Input;
using balance_shaft::RelievedShaft;
using balance_shaft::RelievedShaftSizes;
namespace field = balance_shaft::field;

namespace {

RelievedShaftView::Sized sizedOf(const RelievedShaftSizes& sizes) {
    using Sized = RelievedShaftView::Sized;
    return !sizes.depth      ? Sized::Depth
           : !sizes.length   ? Sized::Length
           : !sizes.diameter ? Sized::Diameter
                             : Sized::None;
}

RelievedShaftSizes sizesOf(const Input& input) {
    return input.relieved_shaft.value_or(RelievedShaftSizes{});
}

}  // namespace

RelievedShaftDrawing::RelievedShaftDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Drawing of the shaft with a relieved middle"));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void RelievedShaftDrawing::setShaft(const RelievedShaft& shaft) {
    shaft_ = shaft;
    update();
}

QSize RelievedShaftDrawing::sizeHint() const {
    return {600, 220};
}

void RelievedShaftDrawing::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = Theme::instance();
    painter.fillRect(rect(), theme.panel());
    painter.setFont(Theme::font(Theme::smallSize));
    if (!shaft_.feasible) {
        painter.setPen(theme.mutedText());
        painter.drawText(rect(), Qt::AlignCenter, tr("No shaft of these sizes"));
        return;
    }
    const double radius = shaft_.diameter / 2.0;
    const double flat = radius - shaft_.depth;
    const double stub = radius;
    // Section at the left, a gap of one diameter, the side view.
    const double wide = 2.0 * radius + 2.0 * radius + shaft_.length + 2.0 * stub;
    const double margin = 36.0;
    const double scale =
        std::min((width() - 2.0 * margin) / wide, (height() - 2.0 * margin) / (2.0 * radius));
    if (scale <= 0.0) {
        return;
    }
    const double top = height() / 2.0;
    const double left = (width() - wide * scale) / 2.0;
    const auto at = [&](double x, double y) { return QPointF(left + x * scale, top - y * scale); };
    const QPen outline(theme.text(), 1.6);
    const QPen axis(theme.mutedText(), 1.0, Qt::DashDotLine);
    const QPen removed(theme.curve(1), 1.2, Qt::DashLine);
    QColor steel = theme.curve(0);
    steel.setAlpha(60);

    // Section.
    const double angle = std::atan2(flat, shaft_.half_width) / degree;
    const QRectF circle(at(0.0, radius), at(2.0 * radius, -radius));
    QPainterPath section;
    section.arcMoveTo(circle, 180.0 - angle);
    section.arcTo(circle, 180.0 - angle, 180.0 + 2.0 * angle);
    section.closeSubpath();
    painter.setPen(outline);
    painter.setBrush(steel);
    painter.drawPath(section);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(removed);
    painter.drawArc(circle, static_cast<int>(16 * angle), static_cast<int>(16 * (180 - 2 * angle)));
    painter.setPen(axis);
    painter.drawLine(at(-0.15 * radius, 0.0), at(2.15 * radius, 0.0));
    painter.drawLine(at(radius, 1.15 * radius), at(radius, -1.15 * radius));
    // Centre of mass.
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.accent());
    painter.drawEllipse(at(radius, -shaft_.centre_of_mass_radius), 3.5, 3.5);

    // Side view.
    const double begin = 4.0 * radius + stub;
    const double end = begin + shaft_.length;
    QPainterPath side;
    side.moveTo(at(begin - stub, -radius));
    for (const QPointF& point :
         {at(end + stub, -radius), at(end + stub, radius), at(end, radius), at(end, flat),
          at(begin, flat), at(begin, radius), at(begin - stub, radius)}) {
        side.lineTo(point);
    }
    side.closeSubpath();
    painter.setPen(outline);
    painter.setBrush(steel);
    painter.drawPath(side);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(removed);
    painter.drawLine(at(begin, radius), at(end, radius));
    painter.setPen(axis);
    painter.drawLine(at(begin - 1.2 * stub, 0.0), at(end + 1.2 * stub, 0.0));

    // Sizes.
    painter.setPen(theme.text());
    const QLocale locale;
    const auto mm = [&](double metres) { return fixedNumber(metres / units::mm, 1, locale); };
    const double below = at(0.0, -radius).y() + 16.0;
    painter.drawText(QRectF(at(0.0, 0.0).x() - 40.0, below, 2.0 * radius * scale + 80.0, 16.0),
                     Qt::AlignCenter, QStringLiteral("⌀ ") + mm(shaft_.diameter));
    const double above = at(0.0, radius).y() - 24.0;
    painter.drawText(QRectF(at(0.0, 0.0).x() - 40.0, above, 2.0 * radius * scale + 80.0, 16.0),
                     Qt::AlignCenter, QStringLiteral("h ") + mm(shaft_.depth));
    painter.drawText(QRectF(at(begin, 0.0).x() - 20.0, above, shaft_.length * scale + 40.0, 16.0),
                     Qt::AlignCenter, QStringLiteral("b ") + mm(shaft_.length));
}

RelievedShaftView::RelievedShaftView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, Theme::space, 0, 0);
    column->setSpacing(Theme::space);
    auto* upper = new QHBoxLayout;
    upper->setSpacing(Theme::space);
    column->addLayout(upper, 2);

    auto* formPanel = new Panel(this);
    auto* formColumn = new QVBoxLayout(formPanel);
    formColumn->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    auto* form = new FormSection(tr("Shaft with a relieved middle"), formPanel);
    sized_ = new QComboBox(form);
    sized_->setAccessibleName(tr("Size that follows from the others"));
    sized_->addItem(tr("depth h"), QVariant::fromValue(Sized::Depth));
    sized_->addItem(tr("length b"), QVariant::fromValue(Sized::Length));
    sized_->addItem(tr("diameter D"), QVariant::fromValue(Sized::Diameter));
    sized_->addItem(tr("nothing, only check"), QVariant::fromValue(Sized::None));
    form->addWidget(tr("&Find"), sized_, {},
                    tr("Two sizes are given, the third follows from the unbalance m₁ ρ₁."));
    connect(sized_, &QComboBox::activated, this,
            [this](int index) { chooseSized(sized_->itemData(index).value<Sized>()); });
    diameter_ = addSize(form, field::bar_diameter);
    depth_ = addSize(form, field::relief_depth);
    length_ = addSize(form, field::relief_length);
    density_ = addSize(form, field::density);
    modulus_ = addSize(form, field::elastic_modulus);
    formColumn->addWidget(form);
    formColumn->addStretch();
    export_ = new QPushButton(tr("E&xport drawing (DXF)…"), formPanel);
    export_->setToolTip(tr("Section and side view, real size, for the machine shop"));
    connect(export_, &QPushButton::clicked, this, &RelievedShaftView::chooseFile);
    formColumn->addWidget(export_);
    upper->addWidget(formPanel, 2);

    auto* answerPanel = new Panel(this);
    auto* answerColumn = new QVBoxLayout(answerPanel);
    answerColumn->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    verdict_ = captionLabel({}, answerPanel);
    answerColumn->addWidget(verdict_);
    table_ = new ResultTable(answerPanel);
    table_->setAccessibleName(tr("Sizes and masses of the shaft"));
    table_->setColumns({tr("Shaft"), tr("Value"), tr("Unit")});
    answerColumn->addWidget(table_);
    answerColumn->addStretch();
    upper->addWidget(answerPanel, 3);

    drawing_ = new RelievedShaftDrawing(this);
    column->addWidget(drawing_, 1);

    connect(model_, &SceneModel::changed, this, [this] {
        if (isVisible()) {
            showAll();
        }
    });
}

NumberField* RelievedShaftView::addSize(FormSection* form, const Field& field) {
    NumberField* size = form->addNumber(field);
    size->setDigits(6);  // a size that was found has more than fit
    size->setModel(model_);
    connect(size, &NumberField::valueEdited, this, [this, &field](std::optional<double> value) {
        model_->editField("/relieved_shaft/" + std::string(field.key), *value, fieldName(field));
    });
    return size;
}

void RelievedShaftView::chooseSized(Sized sized) {
    model_->edit(tr("Size to find"), [&](Input& input) {
        RelievedShaftSizes sizes = sizesOf(input);
        // What was found becomes what is given.
        const auto keep = [](std::optional<double>& size, double found) {
            if (!size && found > 0.0) {
                size = found;
            }
        };
        keep(sizes.diameter, shaft_.diameter);
        keep(sizes.depth, shaft_.depth > 0.0 ? shaft_.depth : shaft_.diameter / 4.0);
        keep(sizes.length, shaft_.length);
        if (sized == Sized::Depth) {
            sizes.depth.reset();
        } else if (sized == Sized::Length) {
            sizes.length.reset();
        } else if (sized == Sized::Diameter) {
            sizes.diameter.reset();
        }
        input.relieved_shaft = sizes;
    });
    showAll();
}

void RelievedShaftView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showAll();
}

void RelievedShaftView::showAll() {
    const RelievedShaftSizes sizes = sizesOf(model_->input());
    shaft_ = model_->relievedShaft();
    const Sized sized = sizedOf(sizes);
    sized_->setCurrentIndex(sized_->findData(QVariant::fromValue(sized)));
    const auto showSize = [&](NumberField* size, double metres, bool given) {
        size->setEnabled(given);
        size->setValue(metres > 0.0 ? std::optional(metres / units::mm) : std::nullopt);
    };
    showSize(diameter_, sizes.diameter.value_or(shaft_.diameter), sized != Sized::Diameter);
    showSize(depth_, sizes.depth.value_or(shaft_.depth), sized != Sized::Depth);
    showSize(length_, sizes.length.value_or(shaft_.length), sized != Sized::Length);
    density_->setValue(sizes.density);
    modulus_->setValue(sizes.elastic_modulus / field::elastic_modulus.unit);

    const QLocale locale;
    const auto row = [&](const QString& name, double value, int digits, const QString& unit) {
        return QStringList{
            name, value > 0.0 ? fixedNumber(value, digits, locale) : QStringLiteral("–"), unit};
    };
    const QString mm = tr("mm");
    table_->setRows({
        row(tr("unbalance needed, m₁ ρ₁"), shaft_.required / units::gram_mm, 0, tr("g·mm")),
        row(tr("unbalance of the shaft"), shaft_.unbalance / units::gram_mm, 0, tr("g·mm")),
        row(tr("width of the flat"), 2.0 * shaft_.half_width / units::mm, 2, mm),
        row(tr("mass of the relieved part"), shaft_.mass, 3, tr("kg")),
        row(tr("mass milled away"), shaft_.removed_mass, 3, tr("kg")),
        row(tr("radius of its centre of mass"), shaft_.centre_of_mass_radius / units::mm, 2, mm),
        row(tr("critical bar radius"), shaft_.critical_radius / units::mm, 2, mm),
        row(tr("critical length"), shaft_.critical_length / units::mm, 1, mm),
        row(tr("sag at speed"), shaft_.sag / units::mm, 3, mm),
        row(tr("bending stress"), shaft_.bending_stress / units::MPa, 1, tr("MPa")),
    });
    table_->setCellToolTip(6, 0, tr("The smallest bar that can have the unbalance at this length"));
    table_->setCellToolTip(7, 0, tr("The shortest relief that can have it with this bar"));
    table_->setCellToolTip(8, 0,
                           tr("Of the relieved part on two supports under its own centrifugal "
                              "load"));
    verdict_->setText(
        shaft_.feasible ? (tr("Feasible.") + QLatin1Char(' ') + messageText(shaft_.note)).trimmed()
                        : messageText(shaft_.reason));
    export_->setEnabled(shaft_.feasible);
    drawing_->setShaft(shaft_);
}

QString RelievedShaftView::exportDxf(const QString& path) const {
    try {
        write_text_file(path.toStdString(), balance_shaft::relieved_shaft_dxf(shaft_, {}));
    } catch (const std::exception& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
    return {};
}

void RelievedShaftView::chooseFile() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Export drawing"),
                                                      QStringLiteral("balance-shaft.dxf"),
                                                      tr("DXF drawings (*.dxf)"));
    if (path.isEmpty()) {
        return;
    }
    const QString trouble = exportDxf(path);
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, tr("Export drawing"), trouble);
    }
}

}  // namespace ravnoves
