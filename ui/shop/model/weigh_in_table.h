#pragma once

#include <functional>
#include <optional>

#include "case-file/field.h"
#include "model/editable_table.h"
#include "shop/weigh_in.h"

namespace ravnoves {

class Words;

/// The weigh-in sheet as a table: a column for each kind of part, a row for each cylinder; above
/// them, where the scene has them, rows for the nominal mass and for the permitted spread. A cell
/// is a number in the unit of its field, or nothing.
class WeighInTable final : public EditableTable {
    Q_OBJECT

  public:
    /// Name of a cell among the page's fields: "nominal_pin", "mass_piston_3".
    static constexpr int KeyRole = TroubleRole + 1;

    /// kg; nothing where the part is not weighed.
    using Mass = std::optional<double>;
    /// The mass of a cell that is on the sheet.
    using Cells = std::function<Mass&(int row, int column)>;
    /// Where the masses are.
    struct Source {
        const Field& mass;  ///< of a part in a cylinder
        bool hasNominal;    ///< rows for nominal masses and permitted spreads
        std::function<int()> cylinders;
        std::function<Mass(int row, int column)> read;
        /// As SceneModel's editing: one step of that name. @return why it is refused
        std::function<QString(const QString& name, const std::function<void(const Cells&)>& change)>
            edit;
    };
    /// That of a model whose input has a weigh-in sheet and whose editWeights() changes it.
    template <typename Model>
    static Source sourceOf(Model* model, const Field& mass, bool hasNominal,
                           std::function<int()> cylinders) {
        const int above = hasNominal ? rowsOfNominal : 0;
        return {mass, hasNominal, std::move(cylinders),
                [model, above](int row, int column) -> Mass {
                    const auto& sheet = model->input().weigh_in;
                    return sheet && row - above < static_cast<int>(sheet->columns[0].mass.size())
                               ? cellOf(*sheet, row, column, above)
                               : Mass();
                },
                [model, above](const QString& name, const auto& change) {
                    return model->editWeights(name, [&](auto& sheet) {
                        change([&](int row, int column) -> Mass& {
                            return cellOf(sheet, row, column, above);
                        });
                    });
                }};
    }

    explicit WeighInTable(Source source, QObject* parent = nullptr);

    /// What is described once for all cells of a row.
    const Field& fieldOf(int row) const;
    /// The row of the first cylinder.
    int firstCylinder() const { return source_.hasNominal ? rowsOfNominal : 0; }

    /// The cell of a row that may not be there yet, for its names.
    QModelIndex createdIndex(int row, int column) const { return createIndex(row, column); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& cell, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// An invalid value empties the cell.
    bool setData(const QModelIndex& cell, const QVariant& value, int role = Qt::EditRole) override;
    /// One step; a cell without text leaves what is there, and where one is refused nothing is
    /// written.
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

  private:
    static constexpr int rowsOfNominal = 2;
    template <typename Sheet>
    static auto& cellOf(Sheet& sheet, int row, int column, int above) {
        auto& part = sheet.columns[static_cast<std::size_t>(column)];
        return row >= above ? part.mass[static_cast<std::size_t>(row - above)]
               : row == 0   ? part.nominal
                            : part.permitted_spread;
    }

    Source source_;
};

/// What stands below a column of the sheet.
struct WeighedColumn {
    QString mean;
    QString deviation;  ///< of the mean from nominal, with its sign
    QString spread;
    bool tooWide = false;
    bool counts = true;  ///< or nothing is weighed
    QString toolTip;
};
/// @param statistics  of the column; nothing where nothing is weighed
/// @param nominal     kg, where it is known
/// @param whyNot      it does not count
WeighedColumn weighedColumn(const Words& words, shop::Part part,
                            const std::optional<shop::ColumnStatistics>& statistics,
                            const std::optional<double>& nominal, bool counts,
                            const QString& whyNot = {});

}  // namespace ravnoves
