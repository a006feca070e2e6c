#pragma once

#include <map>
#include <utility>

#include "model/editable_table.h"
#include "studies/model/study_model.h"

namespace ravnoves {

/// The inputs of a case with what they scatter by, which is edited in place.
class ScatterTable final : public EditableTable {
    Q_OBJECT

  public:
    enum Column { Name, Nominal, Scatter, Columns };

    explicit ScatterTable(StudyModel* model, QObject* parent = nullptr);

    /// These inputs do not scatter any more.
    void removeRowRange(int first, int count) override;
    void takeBackRefused(const QModelIndex& at) override;
    void forgetRefused() override;
    SceneModel* scene() const override { return model_->scene(); }
    void putTyped(const QModelIndex& at, const QString& text, CaseFile& file) override;
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
    /// A text that is no tolerance.
    struct Refused {
        QString text;
        QString why;
        QString before;  ///< what counts in its place
    };
    /// Of all that are refused.
    QString trouble() const;
    /// Where something else than a new text has changed a tolerance, that counts.
    void dropChanged();

    StudyModel* model_;
    int rows_ = 0;
    std::map<std::string, Refused> refused_;  ///< by pointer
};

/// The results that are watched, with their limits.
class WatchTable final : public EditableTable {
    Q_OBJECT

  public:
    enum Column { Name, Least, Most, Columns };

    explicit WatchTable(StudyModel* model, QObject* parent = nullptr);

    /// These results are watched no more.
    void removeRowRange(int first, int count) override;
    void takeBackRefused(const QModelIndex& at) override;
    void forgetRefused() override;
    SceneModel* scene() const override { return model_->scene(); }
    void putTyped(const QModelIndex& at, const QString& text, CaseFile& file) override;
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    using Cell = std::pair<std::string, int>;  ///< pointer and column
    struct Refused {
        QString text;
        QString why;
    };
    /// Takes a text. @return an empty string, or why it cannot be
    QString take(int row, int column, const QString& text);
    /// What a limit refused before may stand beside another one now.
    void retry(int row, int column);
    void dropUnwatched();
    QString trouble() const;

    StudyModel* model_;
    int rows_ = 0;
    std::map<Cell, Refused> refused_;
};

}  // namespace ravnoves
