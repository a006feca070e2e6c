#include "inertia-moments/shaft_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "inertia-moments/fields.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form.h"
#include "widgets/layouts.h"

namespace ravnoves {

using inertia_moments::Balances;
using inertia_moments::Shaft;
namespace field = inertia_moments::field;

class ShaftRow : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftRow)

  public:
    ShaftRow(InertiaMomentsModel* model, int index, Form* form, QWidget* parent)
        : QWidget(parent), form_(form), index_(index) {
        QVBoxLayout* column = columnIn(this, Theme::gap, {0, Theme::gap, 0, Theme::gap});
        auto* first = addLine(column);
        enabled_ = new QCheckBox(this);
        name(enabled_, field::shaft_enabled, "shaft_enabled_%1");
        connect(enabled_, &QCheckBox::clicked, this,
                [=](bool on) { model->setShaftEnabled(index, on); });
        first->addWidget(enabled_);

        trouble_ = new TroubleLine(this);
        addNumber(first, field::shaft_order, "shaft_order_%1", orderWidth);
        addChoice(first, field::shaft_direction);
        addChoice(first, field::shaft_task);

        auto* remove = new QToolButton(this);
        remove->setIcon(themedIcon(QStringLiteral("minus")));
        remove->setAutoRaise(true);
        remove->setObjectName(QStringLiteral("remove_shaft_%1").arg(index));
        remove->setToolTip(tr("Remove this shaft"));
        remove->setAccessibleName(tr("Remove %1").arg(tr("Shaft %1").arg(index + 1)));
        connect(remove, &QToolButton::clicked, this, [=] { model->removeShaft(index); });
        first->addWidget(remove);

        auto* second = addLine(column);
        column->addWidget(trouble_);
        length_ = addNumber(second, field::weight_distance, "shaft_length_%1");
        position_ = addNumber(second, field::shaft_position, "shaft_position_%1");
        addNumber(second, field::weight_radius, "shaft_radius_%1");
        addNumber(second, field::phase_error, "shaft_error_%1")->setOptional(false);
        second->addWidget(new QLabel(unitText(field::phase_error.unit.name), this));
    }

    void show(const Shaft& shaft) {
        enabled_->setChecked(shaft.enabled);
        const bool moment = shaft.balances == Balances::moment;
        length_->parentWidget()->setVisible(moment);
        position_->parentWidget()->setVisible(!moment);
    }

  private:
    static QHBoxLayout* addLine(QVBoxLayout* column) {
        auto* line = new QHBoxLayout;
        line->setSpacing(Theme::gap);
        column->addLayout(line);
        return line;
    }

    /// "Shaft 2: Order of the shaft", with the field's explanation.
    void name(QWidget* widget, const Field& field, const char* objectName) const {
        makeCell(widget);
        widget->setObjectName(QString::fromLatin1(objectName).arg(index_));
        widget->setAccessibleName(
            tr("Shaft %1: %2").arg(QString::number(index_ + 1), fieldName(field)));
        widget->setToolTip(fieldHint(field));
    }

    std::string pointer(const Field& field) const {
        return "/balance_shafts/" + std::to_string(index_) + "/" + std::string(field.key);
    }

    void addChoice(QHBoxLayout* line, const Field& field) {
        auto* box = new QComboBox(this);
        for (const Word& word : field.words) {
            box->addItem(shownText(word.label), box->count());
        }
        name(box, field, "shaft_choice_%1");
        form_->bind(box, pointer(field));
        // The form is narrow: a list takes what room there is.
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(2);
        line->addWidget(box, 1);
    }

    /// @param width  of the field, in pixels; 0: it shares what room there is
    NumberField* addNumber(QHBoxLayout* line, const Field& field, const char* objectName,
                           int width = 0) {
        auto* holder = new QWidget(this);
        QHBoxLayout* pair = rowIn(holder, Theme::gap);
        auto* target = new NumberField(field, holder);
        name(target, field, objectName);
        target->setHint(fieldHint(field));
        if (width > 0) {
            target->setFixedWidth(Theme::withText(width));
        } else {
            target->setMinimumWidth(Theme::withText(46));
        }
        auto* label = new QLabel(
            QStringLiteral("&") + QString::fromStdString(std::string(field.symbol)), holder);
        label->setBuddy(target);
        pair->addWidget(label);
        pair->addWidget(target, 1);
        line->addWidget(holder, width > 0 ? 0 : 1);
        form_->bind(target, pointer(field));
        trouble_->watch(target);
        return target;
    }

    static constexpr int orderWidth = 30;  ///< pixels, for two digits

    Form* form_;
    int index_;
    QCheckBox* enabled_;
    NumberField* length_;    ///< of a shaft against a moment
    NumberField* position_;  ///< of one against a force
    TroubleLine* trouble_;
};

ShaftEditor::ShaftEditor(InertiaMomentsModel* model, Form* form)
    : QWidget(form), model_(model), form_(form) {
    QVBoxLayout* column = columnIn(this, 0);
    list_ = new QVBoxLayout;
    list_->setSpacing(0);
    column->addLayout(list_);
    connect(model_, &SceneModel::changed, this, &ShaftEditor::refresh);
    refresh();
}

void ShaftEditor::refresh() {
    const auto& shafts = model_->input().shafts;
    while (rows_.size() > shafts.size()) {
        // Its own button may be what removed it: it goes when that is done.
        list_->removeWidget(rows_.back());
        rows_.back()->hide();
        rows_.back()->deleteLater();
        rows_.pop_back();
    }
    while (rows_.size() < shafts.size()) {
        auto* row = new ShaftRow(model_, static_cast<int>(rows_.size()), form_, this);
        list_->addWidget(row);
        rows_.push_back(row);
    }
    for (std::size_t i = 0; i < shafts.size(); ++i) {
        rows_[i]->show(shafts[i]);
    }
}

}  // namespace ravnoves
