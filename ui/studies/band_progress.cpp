#include "studies/band_progress.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "model/background_job.h"
#include "model/scene_model.h"
#include "shell/scene_page.h"
#include "studies/tolerance_bands.h"
#include "studies/tolerance_switch.h"
#include "theme/theme.h"

namespace ravnoves {

BandProgress::BandProgress(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      stop_(new QToolButton(this)) {
    setObjectName(QStringLiteral("band_progress"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    constexpr int leastTitle = 60;  // its tip has all of it
    title_->setMinimumWidth(Theme::withText(leastTitle));
    row->addWidget(title_);
    progress_->setRange(0, 100);
    progress_->setFixedWidth(Theme::withText(90));
    row->addWidget(progress_);
    stop_->setObjectName(QStringLiteral("stop_bands"));
    stop_->setFocusPolicy(Qt::TabFocus);
    connect(stop_, &QToolButton::clicked, this, [this] {
        if (bands_) {
            const QString what =
                tr("The bands and ± are those of slopes, or of the samples so far, until "
                   "something changes.");
            bands_->stop(what);
            Q_EMIT stopped(what);
        }
    });
    row->addWidget(stop_);
    connect(&ToleranceSwitch::instance(), &ToleranceSwitch::changed, this,
            &BandProgress::showRunning);
    setTexts();
    hide();
}

void BandProgress::setTexts() {
    progress_->setAccessibleName(tr("Bands: progress"));
    stop_->setText(tr("Stop"));
    stop_->setAccessibleName(tr("Stop the bands"));
    stop_->setToolTip(tr("The bands stay as they are until something changes"));
    showRunning();
}

void BandProgress::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        setTexts();
    }
}

void BandProgress::follow(const ScenePage* page) {
    if (bands_) {
        bands_->job()->disconnect(this);
        bands_->model()->disconnect(this);
    }
    bands_ = page != nullptr
                 ? page->findChild<ToleranceBands*>(QString(), Qt::FindDirectChildrenOnly)
                 : nullptr;
    if (bands_) {
        connect(bands_->job(), &BackgroundJob::runningChanged, this, &BandProgress::showRunning);
        connect(bands_->job(), &BackgroundJob::progress, this,
                [this](double part) { progress_->setValue(static_cast<int>(100.0 * part)); });
        connect(bands_->model(), &SceneModel::changed, this, &BandProgress::showRunning);
        connect(bands_->model(), &SceneModel::studyChanged, this, &BandProgress::showRunning);
    }
    showRunning();
}

void BandProgress::showRunning() {
    const bool isRunning = bands_ && bands_->job()->isRunning();
    const bool isTooLarge = bands_ && bands_->isTooLarge();
    title_->setText(isTooLarge ? tr("No bands and ±: the input is too large for them")
                               : tr("Bands"));
    title_->setToolTip(title_->text());
    progress_->setVisible(isRunning);
    stop_->setVisible(isRunning);
    if (isVisibleTo(parentWidget()) != (isRunning || isTooLarge)) {
        progress_->setValue(0);
        setVisible(isRunning || isTooLarge);
    }
}

}  // namespace ravnoves
