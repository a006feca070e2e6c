#pragma once

#include "model/refusing_table.h"
#include "studies/model/study_model.h"

namespace ravnoves {

/// The inputs of a case with what they scatter by, which is edited in place.
class ScatterTable final : public RefusingTable {
    Q_OBJECT

  public:
    enum Column { Name, Nominal, Scatter, Columns };

    explicit ScatterTable(StudyModel* model, QObject* parent = nullptr);

    /// These inputs do not scatter any more.
    void removeRowRange(int first, int count) override;
    SceneModel* scene() const override { return model_->scene(); }
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    /// Inputs whose tolerance is refused: what is found is without it.
    QStringList refusedNames() const;

  private:
    std::string rowName(int row) const override;
    QString held(int row, int column) const override;
    QString refusedText(const Cell& cell, const Refused& refused) const override;

    StudyModel* model_;
};

/// The results that are watched, with their limits.
class WatchTable final : public RefusingTable {
    Q_OBJECT

  public:
    enum Column { Name, Least, Most, Columns };

    explicit WatchTable(StudyModel* model, QObject* parent = nullptr);

    /// These results are watched no more.
    void removeRowRange(int first, int count) override;
    /// These limits are there no more, as one step.
    void clearLimits(const QModelIndexList& cells);
    void takeBackRefused(const QModelIndex& at) override;
    SceneModel* scene() const override { return model_->scene(); }
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    std::string rowName(int row) const override;
    QString refusedText(const Cell& cell, const Refused& refused) const override;
    /// Takes a block of limits as one step. @return an empty string, or why it cannot be
    QString write(int row, int column, const std::vector<QStringList>& cells);
    /// Takes a text. @return an empty string, or why it cannot be
    QString take(int row, int column, const QString& text);
    /// What a limit refused before may stand beside another one now.
    void retry(int row, int column);

    StudyModel* model_;
};

}  // namespace ravnoves
