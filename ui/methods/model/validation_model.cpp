#include "methods/model/validation_model.h"

#include <QLocale>
#include <algorithm>

#include "methods/model/method_words.h"
#include "plot/model/ticks.h"
#include "text/csv_format.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

using methods::ValidationReport;
using methods::ValidationRow;

namespace {

QVariant alignment(int column) {
    const bool number = column >= ValidationModel::Printed && column <= ValidationModel::Difference;
    return QVariant((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

/// A number of the report with the locale's decimal sign and a true minus.
QString shownNumber(const std::string& text) {
    QString number = QString::fromStdString(text);
    if (number.contains(QLatin1Char('e'))) {
        return powerText(number.section(QLatin1Char(' '), 0, 0).toDouble(), QLocale(), 2) +
               QStringLiteral("\u00A0%");  // only differences are so small
    }
    number = trueMinus(number);
    return number.replace(QLatin1Char('.'), QLocale().decimalPoint());
}

/// In per cent, or in the row's own unit.
QString shownDifference(const ValidationRow& row) {
    std::string text = row.difference_text();
    if (row.unit.empty() || !text.ends_with(row.unit) || row.unit == "%") {
        return shownNumber(text);
    }
    text.resize(text.size() - row.unit.size() - 1);
    return withUnit(shownNumber(text), unitText(row.unit));
}

}  // namespace

QString verdictTitle(methods::Verdict verdict) {
    return shownText(methods::verdict_title(verdict));
}

ValidationModel::ValidationModel(QObject* parent)
    : QAbstractTableModel(parent), job_(new BackgroundJob(this)) {
    connect(job_, &BackgroundJob::failed, this, &ValidationModel::failed);
}

void ValidationModel::load() {
    if (report_ || job_->isRunning()) {
        return;
    }
    job_->start([this](const BackgroundJob::Progress&) -> std::function<void()> {
        auto report = std::make_shared<const ValidationReport>(methods::validate());
        return [this, report] {
            report_ = report;
            filter();
        };
    });
}

void ValidationModel::setPaper(std::optional<std::size_t> paper) {
    paper_ = paper;
    filter();
}

void ValidationModel::setVerdict(std::optional<methods::Verdict> verdict) {
    verdict_ = verdict;
    filter();
}

void ValidationModel::filter() {
    beginResetModel();
    rows_.clear();
    if (report_) {
        for (const ValidationRow& row : report_->rows) {
            const bool paperFits = !paper_ || row.scene == methods::papers()[*paper_].scene;
            if (paperFits && (!verdict_ || row.verdict == *verdict_)) {
                rows_.push_back(&row);
            }
        }
    }
    endResetModel();
    Q_EMIT changed();
}

int ValidationModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ValidationModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

QVariant ValidationModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole) {
        return alignment(section);
    }
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case Paper:
            return tr("Paper");
        case Place:
            return tr("Place");
        case Quantity:
            return tr("Quantity");
        case Unit:
            return tr("Unit");
        case Printed:
            return tr("Printed");
        case Ours:
            return tr("Ours");
        case Difference:
            return tr("Difference");
        case VerdictColumn:
            return tr("Verdict");
        default:
            return {};
    }
}

QVariant ValidationModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const ValidationRow& row = *rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return cell(row, index.column());
        case Qt::ToolTipRole:
            // A narrow table shows neither paper nor place.
            return cell(row, index.column()) + QLatin1Char('\n') +
                   (index.column() > Place ? cell(row, Paper) + QStringLiteral(", ") +
                                                 cell(row, Place) + QLatin1Char('\n')
                                           : QString()) +
                   methodText(row.reason);
        case Qt::TextAlignmentRole:
            return alignment(index.column());
        default:
            return {};
    }
}

QString ValidationModel::cell(const ValidationRow& row, int column) const {
    const auto papers = methods::papers();
    switch (column) {
        case Paper: {
            const auto paper = std::find_if(papers.begin(), papers.end(),
                                            [&](const auto& p) { return p.scene == row.scene; });
            return paper == papers.end() ? QString() : shownText(paper->authors);
        }
        case Place:
            return methodText(row.place);
        case Quantity:
            return methodText(row.quantity);
        case Unit:
            return unitText(row.unit);
        case Printed:
            return shownNumber(row.printed_text);
        case Ours:
            return shownNumber(row.ours_text());
        case Difference:
            return shownDifference(row);
        default:
            return verdictTitle(row.verdict);
    }
}

QString ValidationModel::asText() const {
    QString text;
    for (int row = -1; row < rowCount(); ++row) {
        for (int column = 0; column < Columns; ++column) {
            text += column == 0 ? QString() : QStringLiteral("\t");
            text +=
                row < 0
                    ? headerData(column, Qt::Horizontal).toString()
                    : CsvFormat::plainMinus(cell(*rows_[static_cast<std::size_t>(row)], column));
        }
        text += QLatin1Char('\n');
    }
    return text;
}

QString ValidationModel::countsText() const {
    if (!report_) {
        return tr("computing…");
    }
    const auto count = [this](methods::Verdict verdict) {
        return paper_ ? report_->count(verdict, methods::papers()[*paper_].scene)
                      : report_->count(verdict);
    };
    std::size_t all = 0;
    QStringList parts;
    for (const methods::Verdict verdict : methods::all_verdicts) {
        const std::size_t n = count(verdict);
        all += n;
        parts << QStringLiteral("%1: %2").arg(verdictTitle(verdict)).arg(n);
    }
    return tr("Printed numbers: %1 – %2").arg(all).arg(parts.join(QStringLiteral(", ")));
}

QStringList ValidationModel::paperTitles() const {
    QStringList titles;
    for (const methods::Paper& paper : methods::papers()) {
        titles << shownText(paper.authors);
    }
    return titles;
}

QString ValidationModel::asCsv() const {
    ValidationReport filtered;
    for (const ValidationRow* row : rows_) {
        filtered.rows.push_back(*row);
    }
    return QString::fromStdString(methods::write_csv(filtered));
}

}  // namespace ravnoves
