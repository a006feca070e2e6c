#pragma once

#include "model/editable_table.h"
#include "studies/model/study_model.h"
#include "text/result_row.h"

namespace ravnoves {

/// Rows of a study: names, and cells that are typed. An entry or a paste is one step, all or
/// nothing.
class StudyTable : public EditableTable {
    Q_OBJECT

  public:
    static constexpr int Name = 0;

    SceneModel* scene() const final { return model_->scene(); }
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) final;
    /// What rows with a text that is rejected are called.
    QStringList rejectedNames() const;

    int columnCount(const QModelIndex& parent = {}) const final;
    QVariant data(const QModelIndex& index, int role) const final;
    bool setData(const QModelIndex& index, const QVariant& value, int role) final;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const final;
    Qt::ItemFlags flags(const QModelIndex& index) const final;

  protected:
    /// @param typed  the first column that is typed; those behind it are, too
    /// @param step   name of a change in the history
    StudyTable(StudyModel* model, ResultColumns columns, int typed, QString step, QObject* parent);

    /// @param isEdited  for typing, not for display
    virtual QString text(int row, int column, bool isEdited) const = 0;
    /// Takes the typed text of a cell into a study.
    /// @return an empty string, or why it cannot be
    virtual QString read(studies::Study& next, int row, int column, const QString& typed) const = 0;
    /// What the row is of is no longer there: nothing can be typed for it.
    virtual bool isGone(int /*row*/) const { return false; }

    StudyModel* model_;

  private:
    QString held(int row, int column) const final { return text(row, column, true); }
    QString rejectedText(const Cell& cell, const Rejected& rejected) const final;
    QString write(int row, int column, const std::vector<QStringList>& cells);
    bool isTyped(const QModelIndex& index) const;

    ResultColumns columns_;
    int typed_;
    QString step_;
};

/// The inputs of a case with their scatter.
class ScatterTable final : public StudyTable {
    Q_OBJECT

  public:
    enum Column { Nominal = 1, Scatter };

    explicit ScatterTable(StudyModel* model, QObject* parent = nullptr);

    /// These inputs do not scatter any more.
    void removeRowRange(int first, int count) override;
    int rowCount(const QModelIndex& parent = {}) const override;

  private:
    const StudyModel::Input& input(int row) const;
    std::string rowName(int row) const override { return input(row).pointer; }
    QString text(int row, int column, bool isEdited) const override;
    QString read(studies::Study& next, int row, int column, const QString& typed) const override;
    bool isGone(int row) const override;
};

/// The results that are watched, with their limits.
class WatchTable final : public StudyTable {
    Q_OBJECT

  public:
    enum Column { Minimum = 1, Maximum };

    explicit WatchTable(StudyModel* model, QObject* parent = nullptr);

    /// These results are watched no more.
    void removeRowRange(int first, int count) override;
    int rowCount(const QModelIndex& parent = {}) const override;

  private:
    const studies::Watched& watched(int row) const;
    std::string rowName(int row) const override { return watched(row).pointer; }
    QString text(int row, int column, bool isEdited) const override;
    QString read(studies::Study& next, int row, int column, const QString& typed) const override;
};

}  // namespace ravnoves
