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

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/scene.h"
#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/error_text.h"
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

constexpr double millimetre = 1e-3;      ///< m
constexpr double gramMillimetre = 1e-6;  ///< kg·m

RelievedShaftView::Sized sizedOf(const RelievedShaftSizes& sizes) {
    using Sized = RelievedShaftView::Sized;
    return !sizes.depth      ? Sized::Depth
           : !sizes.length   ? Sized::Length
           : !sizes.diameter ? Sized::Diameter
                             : Sized::None;
}

RelievedShaftSizes sizesOf(const Input& input) {
    return input.relieved_shaft.value_or(balance_shaft::default_relieved_shaft);
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
    const auto mm = [&](double metres) { return fixedNumber(metres / millimetre, 1, locale); };
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
    diameter_ = addSize(form, tr("&Diameter D"), field::bar_diameter,
                        tr("Of the round bar; also the circle that the shaft sweeps."),
                        &RelievedShaftSizes::diameter);
    depth_ = addSize(form, tr("Depth &h"), field::relief_depth,
                     tr("Of the segment that is milled away, from the bar's surface."),
                     &RelievedShaftSizes::depth);
    length_ = addSize(form, tr("&Length b"), field::relief_length,
                      tr("Over which the segment is milled away."), &RelievedShaftSizes::length);
    density_ = form->addNumber(tr("Densit&y"), field::density,
                               tr("Of the bar. Steel 7850, cast iron 7200, tungsten alloy 17500."));
    connect(density_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        model_->edit(tr("Density"), [&](Input& input) {
            RelievedShaftSizes sizes = sizesOf(input);
            sizes.density = *value;
            input.relieved_shaft = sizes;
        });
    });
    modulus_ = form->addNumber(tr("&Elastic modulus"), field::elastic_modulus,
                               tr("For the sag under the shaft's own centrifugal load. Steel 210, "
                                  "cast iron 170, tungsten alloy 360."));
    connect(modulus_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        model_->edit(tr("Elastic modulus"), [&](Input& input) {
            RelievedShaftSizes sizes = sizesOf(input);
            sizes.elastic_modulus = *value * field::elastic_modulus.to_si;
            input.relieved_shaft = sizes;
        });
    });
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

NumberField* RelievedShaftView::addSize(FormSection* form, const QString& label,
                                        const FieldSpec& spec, const QString& hint,
                                        std::optional<double> RelievedShaftSizes::*member) {
    NumberField* size = form->addNumber(label, spec, hint);
    size->setDigits(6);  // a size that was found has more than fit
    const double unit = spec.to_si;
    connect(size, &NumberField::valueEdited, this, [this, member, unit](std::optional<double> v) {
        model_->edit(tr("Relieved shaft"), [&](Input& input) {
            RelievedShaftSizes sizes = sizesOf(input);
            sizes.*member = *v * unit;
            input.relieved_shaft = sizes;
        });
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
    shaft_ = balance_shaft::relieved_shaft(model_->solver());
    const Sized sized = sizedOf(sizes);
    sized_->setCurrentIndex(sized_->findData(QVariant::fromValue(sized)));
    const auto showSize = [&](NumberField* size, double metres, bool given) {
        size->setEnabled(given);
        size->setValue(metres > 0.0 ? std::optional(metres / millimetre) : std::nullopt);
    };
    showSize(diameter_, sizes.diameter.value_or(shaft_.diameter), sized != Sized::Diameter);
    showSize(depth_, sizes.depth.value_or(shaft_.depth), sized != Sized::Depth);
    showSize(length_, sizes.length.value_or(shaft_.length), sized != Sized::Length);
    density_->setValue(sizes.density);
    modulus_->setValue(sizes.elastic_modulus / field::elastic_modulus.to_si);

    const QLocale locale;
    const auto row = [&](const QString& name, double value, int digits, const QString& unit) {
        return QStringList{
            name, value > 0.0 ? fixedNumber(value, digits, locale) : QStringLiteral("–"), unit};
    };
    const QString mm = tr("mm");
    table_->setRows({
        row(tr("unbalance needed, m₁ ρ₁"), shaft_.required / gramMillimetre, 0, tr("g·mm")),
        row(tr("unbalance of the shaft"), shaft_.unbalance / gramMillimetre, 0, tr("g·mm")),
        row(tr("width of the flat"), 2.0 * shaft_.half_width / millimetre, 2, mm),
        row(tr("mass of the relieved part"), shaft_.mass, 3, tr("kg")),
        row(tr("mass milled away"), shaft_.removed_mass, 3, tr("kg")),
        row(tr("radius of its centre of mass"), shaft_.centre_of_mass_radius / millimetre, 2, mm),
        row(tr("critical bar radius"), shaft_.critical_radius / millimetre, 2, mm),
        row(tr("critical length"), shaft_.critical_length / millimetre, 1, mm),
        row(tr("sag at speed"), shaft_.sag / millimetre, 3, mm),
        row(tr("bending stress"), shaft_.bending_stress / 1e6, 1, tr("MPa")),
    });
    table_->setCellToolTip(6, 0, tr("The smallest bar that can have the unbalance at this length"));
    table_->setCellToolTip(7, 0, tr("The shortest relief that can have it with this bar"));
    table_->setCellToolTip(8, 0,
                           tr("Of the relieved part on two supports under its own centrifugal "
                              "load"));
    const double percent = shaft_.required > 0.0 ? 100.0 * shaft_.unbalance / shaft_.required : 0.0;
    if (shaft_.feasible) {
        verdict_->setText(
            shaft_.depth > 0.5 * (1.0 + 1e-9) * shaft_.diameter
                ? tr("Feasible, but more than half of the bar is milled away: a depth of %1 mm "
                     "gives the same unbalance and a stiffer shaft.")
                      .arg(fixedNumber((shaft_.diameter - shaft_.depth) / millimetre, 2, locale))
                : tr("Feasible."));
    } else if (shaft_.unbalance > 0.0) {
        verdict_->setText(tr("These sizes give %1 % of the unbalance that is needed.")
                              .arg(fixedNumber(percent, 1, locale)));
    } else if (shaft_.critical_radius > 0.0) {
        verdict_->setText(
            tr("The bar is too thin: its diameter must be at least %1 mm, or the "
               "relieved length at least %2 mm.")
                .arg(fixedNumber(2.0 * shaft_.critical_radius / millimetre, 1, locale),
                     fixedNumber(shaft_.critical_length / millimetre, 0, locale)));
    } else {
        verdict_->setText(
            tr("There is no such shaft: no unbalance is needed, or it is beyond "
               "these sizes."));
    }
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
