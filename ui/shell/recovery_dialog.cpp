#include "shell/recovery_dialog.h"

#include <QCoreApplication>
#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "model/scene_model.h"
#include "text/language.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {

namespace {

struct RecoveryDialog {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::RecoveryDialog)
};

/// What it is of, its file, its time, as far as known; a job has the journal instead of a file.
QString lineOf(const RecoveredCase& each) {
    QStringList names{SceneModel::titleText(QString::fromStdString(each.content.title))};
    names << JobDesk::wordsOf(each.content);
    names.removeAll(QString());
    const QString scene = SceneModel::titleOf(each.content.scene);
    const bool isJob = each.content.scene == "workshop";
    QStringList kept{!each.path.isEmpty() ? QDir::toNativeSeparators(each.path)
                     : isJob              ? QString()
                                          : RecoveryDialog::tr("no file yet"),
                     timeText(each.saved)};
    kept.removeAll(QString());
    const QString line =
        QStringLiteral("• ") +
        (names.isEmpty() ? scene : scene + QStringLiteral(": ") + names.join(QStringLiteral(", ")));
    return kept.isEmpty()
               ? line
               : line + QStringLiteral(" (") + kept.join(QStringLiteral(", ")) + QLatin1Char(')');
}

}  // namespace

void offerRecovered(QWidget* over, const Recovery::Found& found,
                    const std::function<bool(const RecoveredCase&)>& restore) {
    constexpr qsizetype maximum = 8;  // a box has room for
    const QList<RecoveredCase>& cases = found.cases;
    QStringList lines;
    if (!cases.isEmpty()) {
        lines << RecoveryDialog::tr("The program ended unexpectedly. These cases were not saved:");
    }
    for (const RecoveredCase& each : cases.mid(0, maximum)) {
        lines << lineOf(each);
    }
    if (cases.size() > maximum) {
        lines << QStringLiteral("… (%1)").arg(cases.size());
    }
    for (const QString& file : found.damaged.mid(0, maximum)) {
        lines << RecoveryDialog::tr("The copy of an unsaved case cannot be read; it is now %1.")
                     .arg(file);
    }
    if (lines.isEmpty()) {
        return;
    }
    auto* box = new QMessageBox(QMessageBox::Warning, RecoveryDialog::tr("Unsaved cases"),
                                lines.join(QLatin1Char('\n')), QMessageBox::NoButton, over);
    box->setObjectName(QStringLiteral("recovery"));
    box->setTextFormat(Qt::PlainText);
    box->setAttribute(Qt::WA_DeleteOnClose);
    if (!cases.isEmpty()) {
        box->setDefaultButton(
            box->addButton(RecoveryDialog::tr("&Restore"), QMessageBox::AcceptRole));
        box->addButton(RecoveryDialog::tr("&Discard"), QMessageBox::DestructiveRole);
    }
    box->addButton(cases.isEmpty() ? RecoveryDialog::tr("&Close") : RecoveryDialog::tr("&Later"),
                   QMessageBox::RejectRole)
        ->setToolTip(cases.isEmpty() ? QString()
                                     : RecoveryDialog::tr("Ask again at the next start"));
    QObject::connect(box, &QDialog::finished, over, [=] {
        const auto pressed = box->buttonRole(box->clickedButton());
        if (pressed == QMessageBox::AcceptRole) {
            for (auto each = cases.rbegin(); each != cases.rend(); ++each) {  // the newest in front
                if (restore(*each)) {
                    Recovery::discard(*each);
                }
            }
        } else if (pressed == QMessageBox::DestructiveRole) {
            const QString words = RecoveryDialog::tr(
                                      "Delete these cases permanently? "
                                      "Cases that will be deleted: %1.")
                                      .arg(cases.size());
            if (QMessageBox::question(over, box->windowTitle(), words,
                                      QMessageBox::Yes | QMessageBox::No,
                                      QMessageBox::No) == QMessageBox::Yes) {
                std::ranges::for_each(cases, &Recovery::discard);
            } else {
                offerRecovered(over, found, restore);
            }
        }
    });
    box->open();
}

}  // namespace ravnoves
