#pragma once

#include "model/editable_table.h"
#include "studies/model/study_model.h"

namespace ravnoves {

/// Rows of a study: names, and cells that are typed. An entry or a paste is one step, all or
/// nothing.
class StudyTable : public EditableTable {
    Q_OBJECT

  public:
    static constexpr int Name = 0;

    SceneModel* scene() const final { return model_->scene(); }
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;
    /// What rows with a text that is rejected are called.
    QStringList rejectedNames() const;

    int columnCount(const QModelIndex& parent = {}) const final;
    QVariant data(const QModelIndex& index, int role) const final;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  protected:
    StudyTable(StudyModel* model, QStringList headings, QObject* parent);

    virtual bool isTyped(int row, int column) const = 0;
    /// @param isEdited  for typing, not for display
    virtual QString text(int row, int column, bool isEdited) const = 0;
    /// @return an empty string, or why it cannot be
    virtual QString write(int row, int column, const std::vector<QStringList>& cells) = 0;

    StudyModel* model_;

  private:
    QString rejectedText(const Cell& cell, const Rejected& rejected) const override;

    QStringList headings_;
};

/// The inputs of a case with their scatter.
class ScatterTable final : public StudyTable {
    Q_OBJECT

  public:
    enum Column { Nominal = 1, Scatter };

    explicit ScatterTable(StudyModel* model, QObject* parent = nullptr);

    /// These inputs do not scatter any more.
    void removeRowRange(int first, int count) override;
    /// The last column of the block has the tolerances.
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    const StudyModel::Input& input(int row) const;
    std::string rowName(int row) const override;
    QString held(int row, int column) const override;
    bool isTyped(int row, int column) const override;
    QString text(int row, int column, bool isEdited) const override;
    QString write(int row, int column, const std::vector<QStringList>& cells) override;
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
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  private:
    const studies::Watched& watched(int row) const;
    std::string rowName(int row) const override;
    bool isTyped(int row, int column) const override;
    QString text(int row, int column, bool isEdited) const override;
    QString write(int row, int column, const std::vector<QStringList>& cells) override;
};

}  // namespace ravnoves
