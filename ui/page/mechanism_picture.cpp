#include "page/mechanism_picture.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/value_slider.h"

namespace ravnoves {

namespace {

constexpr int frameMs = 16;
constexpr qint64 longestStepMs = 100;       ///< after a standstill it goes on where it was
constexpr double degreesPerSecond = 150.0;  // slow enough to follow with the eye

}  // namespace

void showCrankAngle(PlotView* plot, CrankAngle* crank) {
    QObject::connect(plot, &PlotView::cursorMoved, crank, &CrankAngle::turnTo);
    QObject::connect(crank, &CrankAngle::changed, plot, &PlotView::setPresentX);
    plot->setPresentX(crank->degrees());
}

MechanismPicture::MechanismPicture(CrankAngle* crank, const QString& name, const QString& hint,
                                   QWidget* parent)
    : QWidget(parent), crank_(crank) {
    makeFigure(this);
    setAttribute(Qt::WA_OpaquePaintEvent);  // nothing behind it is painted first
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(name);
    setToolTip(hint);
    timer_.setInterval(frameMs);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, [this] {
        play(1e-3 * static_cast<double>(std::min(sinceStep_.restart(), longestStepMs)));
    });
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    connect(crank_, &CrankAngle::changed, this, qOverload<>(&QWidget::update));
}

void MechanismPicture::play(double seconds) {
    crank_->turnTo(crank_->degrees() + degreesPerSecond * seconds);
}

void MechanismPicture::setPlaying(bool playing) {
    if (playing == isPlaying()) {
        return;
    }
    sinceStep_.start();
    playing ? timer_.start() : timer_.stop();
    update();
    Q_EMIT playingChanged(playing);
}

void MechanismPicture::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Space:
            setPlaying(!isPlaying());
            return;
        case Qt::Key_Left:
            step(-1.0);
            return;
        case Qt::Key_Right:
            step(1.0);
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void MechanismPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), Theme::instance().panel());
    painter.setRenderHint(QPainter::Antialiasing);
    paintPicture(painter);
}

PicturePanel::PicturePanel(MechanismPicture* picture, const QString& hint, QWidget* parent)
    : Panel(parent), action_(new QAction(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, Theme::gap);
    column->setSpacing(0);
    column->addWidget(picture, 1);
    auto* controls = new QHBoxLayout;
    controls->setContentsMargins(Theme::space, 0, Theme::space, 0);
    controls->setSpacing(Theme::space);
    column->addLayout(controls);
    auto* button = new QToolButton(this);
    button->setAutoRaise(true);
    button->setAccessibleName(tr("Play or pause the picture"));
    controls->addWidget(button);
    const CrankAngle* crank = picture->crank();
    slider_ =
        new ValueSlider(tr("&φ"), {0.0, crank->cycle(), 1.0, 15.0, 0}, QStringLiteral("°"), this);
    slider_->setHint(hint);
    connect(slider_, &ValueSlider::valueEdited, picture, &MechanismPicture::turnTo);
    const auto showAngle = [this](double degrees) { slider_->setValue(std::round(degrees)); };
    connect(crank, &CrankAngle::changed, this, showAngle);
    connect(crank, &CrankAngle::cycleChanged, this,
            [this](double degrees) { slider_->setRange(0.0, degrees); });
    showAngle(crank->degrees());
    controls->addWidget(slider_, 1);
    action_->setToolTip(tr("Turn the crank"));

    const auto toggle = [picture] { picture->setPlaying(!picture->isPlaying()); };
    connect(button, &QToolButton::clicked, picture, toggle);
    connect(action_, &QAction::triggered, picture, toggle);
    const auto show = [this, button](bool playing) {
        const QIcon icon = themedIcon(playing ? QStringLiteral("pause") : QStringLiteral("play"));
        action_->setIcon(icon);
        action_->setText(playing ? tr("&Pause") : tr("&Play"));
        button->setIcon(icon);
        button->setToolTip(playing ? tr("Pause (Space)") : tr("Play (Space)"));
    };
    connect(picture, &MechanismPicture::playingChanged, this, show);
    show(false);
}

void PicturePanel::addControls(const QList<QWidget*>& controls) {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(Theme::space, 0, Theme::space, Theme::gap);
    row->setSpacing(Theme::space);
    for (QWidget* control : controls) {
        row->addWidget(control);
    }
    row->addStretch(1);
    static_cast<QVBoxLayout*>(layout())->insertLayout(1, row);  // below the picture
}

}  // namespace ravnoves
