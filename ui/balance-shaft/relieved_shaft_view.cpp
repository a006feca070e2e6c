#include "balance-shaft/relieved_shaft_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "balance-shaft/fields.h"
#include "balance-shaft/model/relieved_shaft_model.h"
#include "shell/refused_entries.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/figure.h"
#include "widgets/file_dialogs.h"
#include "widgets/form.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

using balance_shaft::RelievedShaft;
using balance_shaft::RelievedShaftSizes;
namespace field = balance_shaft::field;

RelievedShaftDrawing::RelievedShaftDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Drawing of the shaft with a relieved middle"));
    makeFigure(this);
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
    constexpr double muted = 0.35;
    painter.setOpacity(isEnabled() ? 1.0 : muted);
    if (!(shaft_.half_width > 0.0)) {
        painter.setPen(theme.mutedText());
        painter.drawText(rect(), Qt::AlignCenter, tr("No shaft of these sizes"));
        return;
    }
    const double radius = shaft_.diameter / 2.0;
    const double flat = radius - shaft_.depth;
    const double stub = std::max((shaft_.bearing_span - shaft_.length) / 2.0, radius);
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

    // Bearings: a triangle under the bar, its tip at the middle of the journal.
    const double middle = (begin + end) / 2.0;
    painter.setPen(outline);
    painter.setBrush(theme.panel());
    for (const double x :
         {middle - shaft_.bearing_span / 2.0, middle + shaft_.bearing_span / 2.0}) {
        const QPointF tip = at(x, -radius);
        painter.drawPolygon(QPolygonF{tip, tip + QPointF(-6, 10), tip + QPointF(6, 10)});
    }

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
    painter.drawText(QRectF(at(middle, 0.0).x() - 60.0, below, 120.0, 16.0), Qt::AlignCenter,
                     QStringLiteral("L ") + mm(shaft_.bearing_span));
}

RelievedShaftView::RelievedShaftView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(new RelievedShaftModel(model, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, Theme::space, 0, 0);
    column->setSpacing(Theme::space);
    constexpr int pairWidth = 540;
    auto* upper = new FoldingRow(pairWidth, this);
    column->addWidget(upper, 3);
    upper->add(buildForm(model), 2);

    auto* answerPanel = new Panel(this);
    auto* answerColumn = new QVBoxLayout(answerPanel);
    answerColumn->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    verdict_ = captionLabel({}, answerPanel);
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    answerColumn->addWidget(verdict_);
    table_ = new ResultTable(answerPanel);
    table_->setAccessibleName(tr("Sizes and masses of the shaft"));
    table_->setColumns({tr("Shaft"), tr("Value"), tr("Unit")});
    table_->setTips(RelievedShaftModel::tips());
    table_->setShownRows(9);
    answerColumn->addWidget(table_, 1);
    upper->add(answerPanel, 3);

    drawing_ = new RelievedShaftDrawing(this);
    column->addWidget(drawing_, 1);

    connect(model, &SceneModel::changed, this, [this] {
        if (isVisible()) {
            showShaft();
        }
    });
}

QWidget* RelievedShaftView::buildForm(BalanceShaftModel* model) {
    using Sized = RelievedShaftModel::Sized;
    auto* panel = new Panel(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, Theme::space);
    auto* form = new Form(model, panel);
    form->section(tr("Shaft with a relieved middle"));
    sized_ = new QComboBox(form);
    sized_->addItem(tr("depth h"), QVariant::fromValue(Sized::Depth));
    sized_->addItem(tr("length b"), QVariant::fromValue(Sized::Length));
    sized_->addItem(tr("diameter D"), QVariant::fromValue(Sized::Diameter));
    sized_->addItem(tr("nothing, only check"), QVariant::fromValue(Sized::None));
    form->current()->addWidget(
        tr("&Find"), sized_, {},
        tr("Two sizes are given, the third follows from the unbalance m₁ ρ₁."));
    sized_->setAccessibleName(tr("Size that follows from the others"));
    const auto showSized = [this] {
        sized_->setCurrentIndex(sized_->findData(QVariant::fromValue(model_->sized())));
    };
    connect(sized_, &QComboBox::activated, this, [this, showSized](int index) {
        model_->choose(sized_->itemData(index).value<Sized>());
        showSized();
    });
    form->follow(showSized);
    const auto addSize = [&](const Field& field, RelievedShaftModel::Size size) {
        NumberField* number = form->number(
            field, [this, size] { return model_->sizeMm(size); },
            [model, &field](std::optional<double> value) {
                model->editField("/relieved_shaft/" + std::string(field.key), *value,
                                 fieldName(field));
            });
        form->follow([this, number, size] { number->setEnabled(model_->isGiven(size)); });
        number->setDigits(6);  // a size that was found has more than fit
    };
    addSize(field::bar_diameter, &RelievedShaftSizes::diameter);
    addSize(field::relief_depth, &RelievedShaftSizes::depth);
    addSize(field::relief_length, &RelievedShaftSizes::length);
    for (const char* steel : {"density_kg_m3", "elastic_modulus_GPa"}) {
        form->number((std::string("/relieved_shaft/") + steel).c_str());
    }
    form->section(tr("What it must bear"));
    for (const char* limit : {"bearing_span_mm", "allowable_stress_MPa", "permitted_sag_mm",
                              "speed_margin", "bearing_load_limit_N"}) {
        form->number((std::string("/relieved_shaft/") + limit).c_str());
    }
    QScrollArea* area = scrolled(form, panel);
    area->setMinimumHeight(120);
    column->addWidget(area, 1);
    export_ = new QPushButton(tr("E&xport drawing (DXF)…"), panel);
    export_->setToolTip(tr("Section and side view, real size, for the machine shop"));
    connect(export_, &QPushButton::clicked, this, &RelievedShaftView::chooseFile);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(Theme::margin, 0, Theme::margin, 0);
    row->addWidget(export_);
    column->addLayout(row);
    return panel;
}

void RelievedShaftView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    // Fields on the page's other tabs go into the shaft too.
    for (const EntryField* field : entriesOfPage(this)) {
        connect(field, &EntryField::troubleChanged, this, &RelievedShaftView::showShaft,
                Qt::UniqueConnection);
    }
    showShaft();
}

void RelievedShaftView::showShaft() {
    table_->setRows(model_->rows());
    const QStringList refused = refusedEntries(this);
    const bool isTyped = refused.isEmpty();
    verdict_->setText(isTyped ? model_->verdict()
                              : tr("Not of what stands in the form, but of the values before it; "
                                   "refused entries: %1")
                                    .arg(refused.join(QStringLiteral("; "))));
    const Theme& theme = Theme::instance();
    colourText(verdict_, !isTyped                   ? theme.error()
                         : model_->shaft().feasible ? theme.text()
                                                    : theme.warning());
    table_->setEnabled(isTyped);
    drawing_->setEnabled(isTyped);
    export_->setEnabled(model_->shaft().feasible);
    drawing_->setShaft(model_->shaft());
}

void RelievedShaftView::chooseFile() {
    if (!goOnWithoutRefused(this, tr("Export drawing"))) {
        return;
    }
    const QString path =
        askSavePath(this, tr("Export drawing"), QStringLiteral("balance-shaft.dxf"), {dxfFormat()});
    if (path.isEmpty()) {
        return;
    }
    const QString trouble = model_->exportDxf(path);
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, tr("Export drawing"), trouble);
    }
}

}  // namespace ravnoves
