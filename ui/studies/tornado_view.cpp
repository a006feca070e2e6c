#include "studies/tornado_view.h"

#include <algorithm>

#include "pictures/figure.h"
#include "studies/model/study_model.h"
#include "text/csv_format.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

TornadoView::TornadoView(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::RichText);
    setWordWrap(true);
    setAlignment(Qt::AlignTop | Qt::AlignLeft);
    setMargin(Theme::margin);
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
    setToolTip(
        tr("Dark: share of the variance of an input alone (Sobol's first-order index). Light: "
           "further share with other inputs (total index)."));
}

void TornadoView::setShares(const StudyAnswer* value, const StudyModel& study) {
    if (value == nullptr) {
        clear();
        makeFigure(this, [](const CsvFormat& /*format*/) { return QString(); });
        return;
    }
    std::vector<StudyAnswer::Share> shares = value->shares;
    std::ranges::stable_sort(shares, std::greater<>(), &StudyAnswer::Share::whole);
    const QString title =
        tr("Shares of the variance of %1").arg(study.resultName(value->pointer).withUnit());
    const QString dark = Theme::instance().accent().name();
    const QString pale = QStringLiteral("#4d") + dark.mid(1);
    const auto stroke = [](double share, const QString& colour) {
        constexpr double room = 84.0;                           // percent, beside the number
        const int width = qRound(room * std::min(share, 1.0));  // Qt reads whole ones alone
        return width < 1 ? QString()
                         : QStringLiteral("<td width=\"%1%\" bgcolor=\"%2\"></td>")
                               .arg(width)
                               .arg(colour);
    };
    QString rows;
    QStringList names;
    QStringList words;
    for (const StudyAnswer::Share& share : shares) {
        const QString name = study.inputName(share.pointer);
        rows += QStringLiteral(
                    "<tr><td align=\"right\">%1</td><td width=\"60%\"><table width=\"100%\" "
                    "cellspacing=\"0\"><tr>%2%3<td>&nbsp;%4</td></tr></table></td></tr>")
                    .arg(name.toHtmlEscaped(), stroke(share.alone, dark),
                         stroke(share.whole - share.alone, pale), percentText(share.alone));
        names << name;
        words << name + QLatin1Char(' ') + percentText(share.alone);
    }
    setText(
        QStringLiteral("<p><b>%1</b></p><p><span style=\"color:%2\">■</span> %3 &nbsp; "
                       "<span style=\"color:%4\">■</span> %5</p><table width=\"100%\">%6</table>")
            .arg(title.toHtmlEscaped(), dark, tr("alone"), pale, tr("with others"), rows));
    setAccessibleName(title);
    setAccessibleDescription(words.join(QStringLiteral("; ")));
    makeFigure(this, [title, names, shares](const CsvFormat& format) {
        QString text = format.line({title, tr("alone, %"), tr("with others, %")});
        for (std::size_t i = 0; i < shares.size(); ++i) {
            text += format.line({names[static_cast<qsizetype>(i)],
                                 format.number(100.0 * shares[i].alone),
                                 format.number(100.0 * shares[i].whole)});
        }
        return text;
    });
}

}  // namespace ravnoves
