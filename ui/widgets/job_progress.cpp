#include "widgets/job_progress.h"

#include <QPushButton>
#include <cmath>

#include "model/background_job.h"

namespace ravnoves {

JobProgress::JobProgress(BackgroundJob* job, const QString& name, QWidget* parent)
    : QProgressBar(parent), job_(job) {
    constexpr int steps = 1000;
    setRange(0, steps);
    setTextVisible(false);
    setAccessibleName(name);
    connect(job, &BackgroundJob::progress, this,
            [this](double part) { setValue(static_cast<int>(std::lround(steps * part))); });
    connect(job, &BackgroundJob::runningChanged, this, &QProgressBar::reset);
    follow(this);
}

QPushButton* JobProgress::cancelButton(const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, parentWidget());
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, job_, &BackgroundJob::cancel);
    follow(button);
    return button;
}

void JobProgress::follow(QWidget* widget) const {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
    widget->setVisible(job_->isRunning());
    connect(job_, &BackgroundJob::runningChanged, widget, &QWidget::setVisible);
}

}  // namespace ravnoves
