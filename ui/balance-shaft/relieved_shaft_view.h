#pragma once

#include <QWidget>

#include "balance-shaft/relieved_shaft.h"
#include "case-file/field.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class NumberField;
class ResultTable;

/// Section and side view of a shaft with a relieved middle, to scale, with its main sizes.
class RelievedShaftDrawing : public QWidget {
    Q_OBJECT

  public:
    explicit RelievedShaftDrawing(QWidget* parent = nullptr);

    void setShaft(const balance_shaft::RelievedShaft& shaft);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    balance_shaft::RelievedShaft shaft_;
};

/// Sizes a balance shaft made of a round bar with a segment milled away (the paper's Fig. 5) for
/// the unbalance m₁ ρ₁ of the page, draws it and exports the drawing.
class RelievedShaftView : public QWidget {
    Q_OBJECT

  public:
    /// Which size follows from the other two.
    enum class Sized { Depth, Length, Diameter, None };
    Q_ENUM(Sized)

    explicit RelievedShaftView(BalanceShaftModel* model, QWidget* parent = nullptr);

    QComboBox* sizedBox() const { return sized_; }
    NumberField* diameterField() const { return diameter_; }
    NumberField* depthField() const { return depth_; }
    NumberField* lengthField() const { return length_; }
    ResultTable* resultTable() const { return table_; }
    QLabel* verdict() const { return verdict_; }
    QPushButton* exportButton() const { return export_; }
    const balance_shaft::RelievedShaft& shaft() const { return shaft_; }

    /// Writes the drawing; returns what went wrong, empty where nothing did.
    QString exportDxf(const QString& path) const;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void showAll();
    void chooseSized(Sized sized);
    void chooseFile();
    NumberField* addSize(class FormSection* form, const Field& field);

    BalanceShaftModel* model_;
    balance_shaft::RelievedShaft shaft_;
    QComboBox* sized_;
    NumberField* diameter_;
    NumberField* depth_;
    NumberField* length_;
    NumberField* density_;
    NumberField* modulus_;
    ResultTable* table_;
    QLabel* verdict_;
    QPushButton* export_;
    RelievedShaftDrawing* drawing_;
};

}  // namespace ravnoves
