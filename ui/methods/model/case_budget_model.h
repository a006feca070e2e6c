#pragma once

#include <QObject>
#include <QStringList>
#include <optional>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/case_file.h"
#include "case-file/verdict.h"
#include "methods/case_budget.h"
#include "model/background_job.h"
#include "text/field_names.h"
#include "text/result_row.h"

namespace ravnoves {

struct OpenCase {
    CaseFile file;
    CaseContext context;
};

/// How sure the leading results of the open case are, as "This case" shows it.
class CaseBudgetModel : public QObject {
    Q_OBJECT

  public:
    explicit CaseBudgetModel(QObject* parent = nullptr);

    /// Solves a case with each of its choices made otherwise, in a worker; the last one counts.
    /// Nothing: no case is open.
    void load(const std::optional<OpenCase>& open);
    bool isRunning() const { return job_->isRunning(); }

    const std::optional<OpenCase>& open() const { return open_; }
    /// The first leading result and what moves it most.
    Verdict verdict() const;
    /// Each leading result, and below it its contributions, largest first.
    Results results() const;
    /// What the scene's model leaves out, sentence by sentence.
    QStringList leftOut() const;

  Q_SIGNALS:
    void changed();

  private:
    QString nameOf(const methods::Contribution& contribution) const;

    BackgroundJob* job_;
    std::optional<OpenCase> open_;
    FieldNames names_;  ///< of its input
    std::vector<methods::CaseDoubt> budget_;
    QString trouble_;
    bool isIncomplete_ = false;  ///< an input is missing
};

}  // namespace ravnoves
