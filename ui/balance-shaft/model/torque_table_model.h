#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <string>

#include "balance-shaft/torque_table.h"
#include "model/editable_table.h"

namespace ravnoves {

namespace balance_shaft {
struct Input;
}
class BalanceShaftModel;

/// The torque table while it is being edited.
///
/// Cells hold what was typed, valid or not, so nothing is lost. checkedTable() is a cycle: of the
/// cells that are rejected it has what was there before, and trouble() says why they are. The
/// first and the last row are one instant of the cycle: a torque typed in one goes to the other.
class TorqueTableModel : public EditableTable {
    Q_OBJECT

  public:
    enum Column { CrankAngle = 0, Torque = 1 };

    using EditableTable::EditableTable;

    /// The case that the table is part of.
    void setModel(BalanceShaftModel* model) { model_ = model; }

    /// Adopts a valid table. What is rejected in a cell stands until the table differs there.
    void setTable(const balance_shaft::TorqueTable& table);
    const balance_shaft::TorqueTable& checkedTable() const { return valid_; }
    /// Why cells are rejected; empty where none is.
    QString trouble() const { return trouble_; }

    void insertRowBelow(int row) override;
    void removeRowRange(int first, int count) override;
    /// Replaces the whole table by text from a spreadsheet, in the unit that the column shows where
    /// the text names none.
    /// @return what was read, as a sentence; throws InputError and changes nothing
    QString replaceByText(const std::string& text);
    /// Replaces the whole table by another, as if it had been typed.
    void replaceBy(const balance_shaft::TorqueTable& table);
    void takeBackRefused(const QModelIndex& at) override;
    void forgetRefused() override;
    /// The whole table, whose numbers are in SI units; nothing of one so long that it takes a
    /// while.
    SceneModel* scene() const override;
    /// Puts the table into an input.
    static void putInto(balance_shaft::Input& input, const balance_shaft::TorqueTable& table);
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  Q_SIGNALS:
    /// checkedTable() differs from the one before.
    void tableEdited();

  private:
    /// What was typed in place of a row's numbers, valid or not.
    struct Typed {
        std::optional<QString> angle;
        std::optional<QString> torque;
        Unit unit = units::N_m;  ///< that the torque was typed in
    };
    /// Texts are made when they are seen: a table may have a million rows. The numbers are those of
    /// the case.
    struct Row {
        double angle = 0.0;              ///< °
        double torque = 0.0;             ///< N·m
        std::unique_ptr<Typed> typed{};  ///< null: nothing
    };

    static QString textOf(const Row& row, int column);
    static QString ownText(const Row& row, int column);
    bool beginsWithAngles(const std::vector<QStringList>& cells) const;
    static std::optional<double> angleOf(const Row& row);
    static std::optional<double> torqueOf(const Row& row);
    static void type(Row& row, int column, const QString& text);
    void put(const QModelIndex& index, const QString& text);
    void showAnew(const balance_shaft::TorqueTable& table);
    void follow(const balance_shaft::TorqueTable& table);
    /// Why a row is rejected; empty where it is not.
    QString refusedText(std::size_t row) const;
    /// The same of all rows, up to a few.
    QString refusedTexts() const;
    enum class Cells {
        typed,  ///< those that are numbers; else what the case holds
        taken   ///< those that are not rejected; else what the case holds
    };
    balance_shaft::TorqueTable tableOf(Cells which) const;
    void check();
    static std::optional<double> numberOf(const Row& row, int column);
    /// A number that the case does not hold.
    bool isPending(std::size_t row, int column) const;
    double shownAngle(std::size_t row) const;
    // Pending cells:
    bool isOutOfOrder(std::size_t row) const;   ///< an angle not between its neighbours'
    bool isBeyondCycle(std::size_t row) const;  ///< the first or last angle: no cycle lies between
    bool isOpenEnd(std::size_t row) const;      ///< the first and last torque differ
    /// True for a cell that is no number or that is rejected beside the others.
    bool isRefused(int row, int column) const;

    BalanceShaftModel* model_ = nullptr;
    std::vector<Row> rows_;
    balance_shaft::TorqueTable valid_;
    QString trouble_;
};

}  // namespace ravnoves
