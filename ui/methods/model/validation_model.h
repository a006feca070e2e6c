#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "case-file/verdict.h"
#include "methods/validation/validation.h"
#include "model/background_job.h"
#include "text/result_row.h"

namespace ravnoves {

/// The validation report as the page shows it: computed once, in a worker thread, then filtered by
/// paper and verdict.
class ValidationModel : public QObject {
    Q_OBJECT

  public:
    enum Column { Place, Quantity, Unit, Printed, Ours, Difference, VerdictColumn };

    explicit ValidationModel(QObject* parent = nullptr);

    /// Computes the report if it is not there and not on the way.
    void load();
    bool isRunning() const { return job_->isRunning(); }
    const methods::ValidationReport* report() const { return report_.get(); }
    /// Whether a printed number differs without a reason, of all papers.
    Verdict verdict() const;

    /// Index in methods::papers(); empty: all of them.
    void setPaper(std::optional<std::size_t> paper);
    void setVerdict(std::optional<methods::Verdict> verdict);

    /// The rows that pass the filters, also in the user's words and decimal sign, the verdict last.
    const std::vector<const methods::ValidationRow*>& rows() const { return rows_; }
    Results results() const;
    /// "430 printed numbers: 370 reproduced, …", of the paper that is chosen.
    QString countsText() const;
    QStringList paperTitles() const;
    /// The filtered rows as CSV with a header, numbers in full precision.
    QString asCsv() const;

  Q_SIGNALS:
    void changed();
    void failed(const QString& why);

  private:
    void filter();

    BackgroundJob* job_;
    std::shared_ptr<const methods::ValidationReport> report_;
    std::optional<std::size_t> paper_;
    std::optional<methods::Verdict> verdict_;
    std::vector<const methods::ValidationRow*> rows_;
};

/// A verdict in the user's language.
QString verdictTitle(methods::Verdict verdict);

}  // namespace ravnoves
