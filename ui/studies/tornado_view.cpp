#include "studies/tornado_view.h"

#include <QPainter>
#include <algorithm>

#include "pictures/figure.h"
#include "studies/model/result_words.h"
#include "studies/model/study_model.h"
#include "text/csv_format.h"
#include "text/number_text.h"

namespace ravnoves {

TornadoView::TornadoView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setToolTip(
        tr("Dark: share of the variance of an input alone (Sobol's first-order index). Light: "
           "further share with other inputs (total index)."));
    makeFigure(this, [this](const CsvFormat& format) {
        if (bars_.empty()) {
            return QString();
        }
        QString text = format.line({title_, tr("alone, %"), tr("with others, %")});
        for (const Bar& bar : bars_) {
            text += format.line(
                {bar.name, format.number(100.0 * bar.alone), format.number(100.0 * bar.whole)});
        }
        return text;
    });
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TornadoView::setBars(const QString& title, std::vector<Bar> bars) {
    std::stable_sort(bars.begin(), bars.end(),
                     [](const Bar& a, const Bar& b) { return a.whole > b.whole; });
    title_ = title;
    bars_ = std::move(bars);
    QStringList words;
    for (const Bar& bar : bars_) {
        words << bar.name + QStringLiteral(" ") + percentText(bar.alone);
    }
    setAccessibleName(title_);
    setAccessibleDescription(words.join(QStringLiteral("; ")));
    update();
}

void TornadoView::setFaded(bool faded) {
    if (faded_ != faded) {
        faded_ = faded;
        update();
    }
}

void TornadoView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = Theme::instance();
    painter.fillRect(rect(), theme.panel());
    painter.setOpacity(faded_ ? 0.45 : 1.0);
    painter.setPen(theme.text());
    painter.setFont(Theme::font(Theme::baseSize, true));
    const double line = QFontMetricsF(painter.font()).height();
    const QRectF inner = QRectF(rect()).adjusted(Theme::margin, Theme::space, -Theme::margin, 0);
    painter.drawText(
        QRectF(inner.left(), inner.top(), inner.width(), line), Qt::AlignLeft,
        QFontMetricsF(painter.font()).elidedText(title_, Qt::ElideRight, inner.width()));
    painter.setFont(Theme::font());
    const QFontMetricsF metrics(painter.font());
    const double row = metrics.height() + 8.0;
    QColor pale = theme.accent();
    pale.setAlphaF(0.3F);
    double x = inner.left();
    const auto explain = [&](const QColor& colour, const QString& text) {
        const double side = metrics.height() - 6.0;
        const double above = inner.top() + line + Theme::gap;
        painter.fillRect(QRectF(x, above + 3.0, side, side), colour);
        x += side + Theme::gap;
        painter.drawText(QRectF(x, above, inner.right() - x, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
        x += metrics.horizontalAdvance(text) + 2 * Theme::space;
    };
    painter.setPen(theme.mutedText());
    if (!bars_.empty()) {
        explain(theme.accent(), tr("alone"));
        explain(pale, tr("with others"));
    }
    const double top = inner.top() + line + metrics.height() + Theme::gap + Theme::space;
    const double nameWidth = [&] {
        double widest = 0.0;
        for (const Bar& bar : bars_) {
            widest = std::max(widest, metrics.horizontalAdvance(bar.name));
        }
        return std::min(widest, 0.45 * inner.width());
    }();
    const double valueWidth = metrics.horizontalAdvance(QStringLiteral("100,0 %")) + Theme::space;
    const double left = inner.left() + nameWidth + Theme::space;
    const double room = inner.right() - valueWidth - left;
    const auto fitting =
        std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>((height() - top) / row));
    const bool isCut = std::ssize(bars_) > fitting;
    const std::ptrdiff_t shown = std::min(std::ssize(bars_), fitting - (isCut ? 1 : 0));
    double y = top;
    for (std::ptrdiff_t i = 0; i < shown; ++i) {
        const Bar& bar = bars_[static_cast<std::size_t>(i)];
        painter.setPen(theme.text());
        painter.drawText(QRectF(inner.left(), y, nameWidth, row), Qt::AlignRight | Qt::AlignVCenter,
                         metrics.elidedText(bar.name, Qt::ElideMiddle, nameWidth));
        const auto length = [&](double share) { return room * std::clamp(share, 0.0, 1.0); };
        painter.fillRect(QRectF(left, y + 4.0, length(bar.whole), row - 8.0), pale);
        painter.fillRect(QRectF(left, y + 4.0, length(bar.alone), row - 8.0), theme.accent());
        painter.drawText(
            QRectF(left + length(std::max(bar.alone, bar.whole)) + Theme::gap, y, valueWidth, row),
            Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, percentText(bar.alone));
        y += row;
    }
    if (isCut) {
        painter.setPen(theme.mutedText());
        painter.drawText(QRectF(inner.left(), y, inner.width(), row),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         tr("others: %1").arg(std::ssize(bars_) - shown));
    }
}

void showShares(TornadoView& view, const StudyAnswer& value, const StudyModel& study) {
    std::vector<TornadoView::Bar> bars;
    for (const StudyAnswer::Share& share : value.shares) {
        bars.push_back({study.inputName(share.pointer), share.alone, share.whole});
    }
    view.setBars(TornadoView::tr("Shares of the variance of %1")
                     .arg(study.resultName(value.pointer).withUnit()),
                 std::move(bars));
}

}  // namespace ravnoves
