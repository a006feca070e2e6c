#pragma once

#include <QWidget>
#include <functional>
#include <utility>

#include "case-file/field.h"

class QGridLayout;
class QLabel;
class QSlider;

namespace ravnoves {

class NumberField;
class SceneModel;
class TroubleLine;

/// How a slider moves a value, in the value's unit.
struct SliderScale {
    double min, max;  ///< the ends between which a hand moves it
    double step, page;
    int decimals;  ///< −1: as many as a value needs
    /// Else it follows the value's logarithm in steps of this number, a page is a decade, and the
    /// value is rounded to significant digits; the ends are positive.
    int stepsPerDecade = 0;
    int digits = 0;
};

/// A slider with a field for one value: drag, arrow keys (one step), page keys (a larger step),
/// wheel. Where the row is too narrow for a usable slider it is below label and field. The reason
/// for a rejection is below, until another value is given.
class ValueSlider : public QWidget {
    Q_OBJECT

  public:
    /// @param label  with & for the mnemonic
    ValueSlider(const QString& label, const SliderScale& scale, const QString& unit,
                QWidget* parent = nullptr);
    ~ValueSlider() override;

    double value() const { return value_; }
    void setValue(double value);  ///< no signal
    void setRange(double min, double max);
    void setHint(const QString& hint);
    QSlider* slider() const { return slider_; }
    NumberField* box() const { return box_; }
    /// Why the latest value is rejected; empty where it is not.
    QString trouble() const;
    /// Typing is an editing of this model, and its rejections are shown below.
    void setModel(SceneModel* model);
    /// Gives their labels, fields and units one width each, so that a column of them is in line.
    static void align(const QList<ValueSlider*>& sliders);
    QSize sizeHint() const override;  ///< in one row
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    /// The user moved it.
    void valueEdited(double value);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    /// As setValue(), but a text being typed is kept.
    void setBesideTyped(double value);

  private:
    int widthInOneRow() const;
    void edit(double value);
    void showRange();
    int tickOf(double value) const;
    double valueAt(int tick) const;

    QGridLayout* grid_;
    QLabel* label_;
    QSlider* slider_;
    NumberField* box_;
    QLabel* unit_;
    TroubleLine* trouble_;
    bool folded_ = false;
    bool isPassing_ = false;
    SliderScale scale_;
    double value_ = 0.0;
};

/// What a slider has of its own in place of what follows from its field, in its unit.
struct SliderOwn {
    QString label{};
    QString hint{};
    QString name{};           ///< of its box; the slider's has "_slider" behind it
    Unit unit = units::none;  ///< none: the field's
    std::function<std::pair<double, double>()> ends{};  ///< where it may be moved now
    std::function<bool()> isMovable{};
    std::function<bool()>
        isGiven{};  ///< by the case; else the value shown is dimmed; typed again, it is passed on
    // Of a number that is more than the field.
    std::function<double()> read{};
    std::function<void(double)> write{};
};

/// A slider for a number of the input: label with mnemonic, unit, hint, object names and the name
/// of the undo step follow from the field's description in core. It drags the model, follows it and
/// returns where it is rejected. It widens for a case beyond its ends.
class FieldSlider : public ValueSlider {
    Q_OBJECT

  public:
    /// @param pointer  of the field below "input"; a literal
    FieldSlider(SceneModel* model, const char* pointer, const SliderScale& scale, QWidget* parent,
                const SliderOwn& own = {});

    /// Shows the present value. Its ends rest while it is dragged.
    void follow();

  private:
    FieldSlider(SceneModel* model, const char* pointer, const Field& field,
                const SliderScale& scale, QWidget* parent, const SliderOwn& own);

    SliderOwn own_;
};

}  // namespace ravnoves
