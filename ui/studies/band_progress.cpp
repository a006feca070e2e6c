#include "studies/band_progress.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "model/background_job.h"
#include "shell/scene_page.h"
#include "studies/tolerance_bands.h"
#include "theme/theme.h"

namespace ravnoves {

BandProgress::BandProgress(QWidget* parent) : QWidget(parent), progress_(new QProgressBar(this)) {
    setObjectName(QStringLiteral("band_progress"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(tr("Bands"), this));
    progress_->setRange(0, 100);
    progress_->setAccessibleName(tr("Bands: progress"));
    progress_->setFixedWidth(Theme::withText(90));
    row->addWidget(progress_);
    auto* stop = new QToolButton(this);
    stop->setText(tr("Stop"));
    stop->setObjectName(QStringLiteral("stop_bands"));
    stop->setAccessibleName(tr("Stop the bands"));
    stop->setToolTip(tr("The bands stay as they are until something changes"));
    stop->setFocusPolicy(Qt::TabFocus);
    connect(stop, &QToolButton::clicked, this, [this] {
        if (bands_) {
            bands_->stop();
        }
    });
    row->addWidget(stop);
    hide();
}

void BandProgress::follow(const ScenePage* page) {
    if (bands_) {
        bands_->job()->disconnect(this);
    }
    bands_ = page != nullptr
                 ? page->findChild<ToleranceBands*>(QString(), Qt::FindDirectChildrenOnly)
                 : nullptr;
    if (bands_) {
        connect(bands_->job(), &BackgroundJob::runningChanged, this, &BandProgress::showRunning);
        connect(bands_->job(), &BackgroundJob::progress, this,
                [this](double part) { progress_->setValue(static_cast<int>(100.0 * part)); });
    }
    showRunning();
}

void BandProgress::showRunning() {
    const bool isRunning = bands_ && bands_->job()->isRunning();
    if (isVisibleTo(parentWidget()) != isRunning) {
        progress_->setValue(0);
        setVisible(isRunning);
    }
}

}  // namespace ravnoves
