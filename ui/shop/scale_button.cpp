#include "shop/scale_button.h"

#include "shop/model/scale_reader.h"
#include "shop/scale_dialog.h"
#include "shop/scale_input.h"
#include "text/preferences.h"
#include "theme/theme.h"

namespace ravnoves {

using shop::ScaleLine;

ScaleButton::ScaleButton(QWidget* parent) : QToolButton(parent), reader_(new ScaleReader(this)) {
    setObjectName(QStringLiteral("scale_button"));
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);  // a click must not take the focus from the cell
    connect(reader_, &ScaleReader::connectionChanged, this, [this] {
        showConnection();
        if (!reader_->trouble().isEmpty()) {
            Q_EMIT status(reader_->trouble());
        }
    });
    connect(reader_, &ScaleReader::lineRead, this,
            [this](const QByteArray& /*raw*/, const ScaleLine& line) {
                showLine(line);
                if (!reader_->rejection().isEmpty()) {
                    Q_EMIT status(reader_->rejection());
                }
            });
    connect(reader_, &ScaleReader::weighed, this, [this](const ScaleLine& line) {
        if (settings_ == nullptr) {
            Q_EMIT status(enterWeight(line));
        }
    });
    connect(reader_, &ScaleReader::repeated, this, [this](const ScaleLine& line) {
        Q_EMIT status(
            tr("%1 not entered: sent again too soon. If the scale sends continuously, change its "
               "settings.")
                .arg(scaleText(line)));
    });
    connect(&Preferences::instance(), &Preferences::changed, this, &ScaleButton::showConnection);
    connect(&Theme::instance(), &Theme::changed, this, &ScaleButton::showConnection);
    reader_->use(ScaleSettings::load());
    showConnection();
}

void ScaleButton::openSettings() {
    if (settings_ != nullptr) {
        return;
    }
    reader_->use(reader_->settings());  // maybe for another scale
    settings_ = new ScaleDialog(reader_, window());
    settings_->setAttribute(Qt::WA_DeleteOnClose);
    settings_->open();
}

void ScaleButton::showConnection() {
    const bool isSetUp = !reader_->settings().port.isEmpty();
    setVisible(isSetUp);
    const bool isThere = reader_->isConnected() && reader_->trouble().isEmpty();
    setText(isThere ? tr("Scale: ready") : tr("Scale: not connected"));
    setAccessibleName(text());
    setToolTip(isThere ? tr("Masses are entered in the field with the focus. Click for settings.")
                       : reader_->trouble());
    setAccessibleDescription(toolTip());
    QPalette colours = palette();
    colours.setColor(QPalette::ButtonText,
                     isThere ? Theme::instance().text() : Theme::instance().error());
    setPalette(colours);
}

void ScaleButton::showLine(const ScaleLine& line) {
    if (line.kind != ScaleLine::Kind::other) {
        setText(tr("Scale: %1").arg(meaningOf(line)));
    }
}

}  // namespace ravnoves
