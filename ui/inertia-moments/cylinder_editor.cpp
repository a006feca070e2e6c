#include "inertia-moments/cylinder_editor.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

#include "inertia-moments/model/cylinder_table_model.h"
#include "inertia-moments/model/inertia_moments_model.h"

namespace ravnoves {

CylinderEditor::CylinderEditor(InertiaMomentsModel* model, QWidget* parent)
    : TableEditor(new CylinderTableModel(model), tr("Cylinders"), tr("Add a cylinder below"),
                  tr("Remove the selected cylinders"), parent),
      model_(model),
      table_(static_cast<CylinderTableModel*>(table())) {
    table_->setParent(this);
    evenFiring_ = new QPushButton(tr("E&ven firing"), this);
    evenFiring_->setObjectName(QStringLiteral("even_firing"));
    evenFiring_->setToolTip(
        tr("Sets the crankpins for even firing in the firing order. The second bank is shifted by "
           "γ + 2 φ_TDC (the paper prints γ + φ_TDC)."));
    connect(evenFiring_, &QPushButton::clicked, this,
            [this] { table_->say(model_->setEvenFiring()); });
    tools()->addWidget(evenFiring_);
    articulated_ = new QCheckBox(tr("A&rticulated rods"), this);
    articulated_->setObjectName(QStringLiteral("articulated"));
    articulated_->setToolTip(
        tr("On a shared crankpin one rod is the master, the others are attached by knuckle pins, "
           "as in radials. Off: all rods run on the crankpin."));
    qobject_cast<QBoxLayout*>(layout())->insertWidget(2, articulated_);
    connect(articulated_, &QCheckBox::clicked, this, [this](bool on) {
        table_->say(model_->setArticulatedRods(on));
        showState();  // where rejected
    });

    connect(table_, &EditableTable::troubleChanged, this,
            [this](const QString& trouble) { say(trouble, true); });
    connect(model_, &SceneModel::changed, this, &CylinderEditor::showState);
    showState();
}

void CylinderEditor::showState() {
    const bool articulated = model_->hasArticulatedRods();
    articulated_->setChecked(articulated);
    articulated_->setVisible(articulated || model_->hasSharedPins());
    view()->horizontalHeader()->setSectionResizeMode(articulated ? QHeaderView::ResizeToContents
                                                                 : QHeaderView::Stretch);
    caption()->setText(
        articulated ? tr("A knuckle radius makes a rod articulated; blank: the rod runs on the "
                         "crankpin. Values in italics follow from others.")
        : model_->input().layout
            ? tr("The cylinders of the layout chosen. Editing one makes this a table "
                 "of your own; Ctrl+V pastes from a spreadsheet.")
            : tr("Your own table. Double-click a cell to edit; Ctrl+V pastes from a "
                 "spreadsheet."));
    const bool ordered = !model_->firingOrderText().isEmpty();
    evenFiring_->setEnabled(ordered && !articulated);
}

}  // namespace ravnoves
