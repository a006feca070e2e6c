#include "widgets/compared_figure.h"

#include "widgets/figure.h"

namespace ravnoves {

ComparedFigure::ComparedFigure(QWidget* parent) : QWidget(parent) {
    static int made = 0;
    number_ = ++made;
    makeFigure(this);
}

void ComparedFigure::setReference(ComparedFigure* figure, const QString& name) {
    if (reference_ != nullptr) {
        disconnect(reference_, nullptr, this, nullptr);
    }
    reference_ = figure;
    referenceName_ = name;
    if (figure != nullptr) {
        connect(figure, &ComparedFigure::pictureChanged, this, qOverload<>(&QWidget::update));
    }
    update();
}

}  // namespace ravnoves
