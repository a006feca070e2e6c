#include "shell/help_window.h"

#include <QFile>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "text/language.h"
#include "theme/theme.h"

namespace ravnoves {

HelpWindow::HelpWindow(const QString& topic, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Help"));
    setSizeGripEnabled(true);
    resize(720, 620);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* text = new QTextBrowser(this);
    text->setFrameShape(QFrame::NoFrame);
    text->document()->setDocumentMargin(Theme::margin * 2);
    text->document()->setDefaultFont(Theme::font(Theme::baseSize + 1));
    column->addWidget(text);
    text->setSearchPaths({QStringLiteral(":/help")});  // of the pictures

    QFile file(QStringLiteral(":/help/%1.%2.md").arg(topic, currentLanguage()));
    if (!file.exists()) {
        file.setFileName(QStringLiteral(":/help/%1.md").arg(topic));
    }
    if (file.open(QIODevice::ReadOnly)) {
        text->setMarkdown(QString::fromUtf8(file.readAll()));
    } else {
        text->setPlainText(tr("There is no help on this page yet."));
    }
}

}  // namespace ravnoves
