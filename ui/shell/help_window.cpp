#include "shell/help_window.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QSvgRenderer>
#include <QTextBrowser>

#include "shell/help_pages.h"
#include "text/preferences.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/dialog_size.h"
#include "widgets/layouts.h"
#include "widgets/text_length.h"

namespace ravnoves {

namespace {

/// Draws the figures in the colours of the theme, as sharp as the screen is.
class HelpText : public QTextBrowser {
  public:
    using QTextBrowser::QTextBrowser;

    QVariant loadResource(int type, const QUrl& name) override {
        const QString file = name.toString();
        if (type != QTextDocument::ImageResource || !file.endsWith(QLatin1String(".svg"))) {
            return QTextBrowser::loadResource(type, name);
        }
        QSvgRenderer picture(themedSvg(QStringLiteral(":/help/") + file));
        const QSize size = picture.defaultSize();
        QImage image(size * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
        image.setDevicePixelRatio(devicePixelRatioF());
        image.fill(Qt::transparent);
        QPainter painter(&image);
        picture.render(&painter, QRectF(QPointF(), size));
        return image;
    }
};

}  // namespace

HelpWindow::HelpWindow(const QString& topic, QWidget* parent) : QDialog(parent), topic_(topic) {
    setSizeGripEnabled(true);
    resizeWithText(this, 980, 680);
    QVBoxLayout* column = columnIn(this, 0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    field_ = new QLineEdit(this);
    field_->setObjectName(QStringLiteral("help-search"));
    field_->setClearButtonEnabled(true);
    limitLength(field_, 200);
    row->addWidget(field_, 1);
    found_ = new QLabel(this);
    found_->setObjectName(QStringLiteral("help-found"));
    row->addWidget(found_);
    column->addLayout(row);

    auto* halves = new QSplitter(this);
    halves->setChildrenCollapsible(false);
    list_ = new QListWidget(halves);
    list_->setObjectName(QStringLiteral("help-list"));
    list_->setWordWrap(true);
    list_->setResizeMode(QListView::Adjust);
    list_->setSpacing(2);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    text_ = new HelpText(halves);
    text_->setFrameShape(QFrame::NoFrame);
    text_->setSearchPaths({QStringLiteral(":/help")});
    text_->document()->setDocumentMargin(Theme::margin * 2);
    text_->document()->setDefaultFont(Theme::font(Theme::baseSize + 1));
    halves->setStretchFactor(1, 1);
    halves->setSizes({Theme::withText(250), Theme::withText(730)});
    column->addWidget(halves, 1);

    renew();
    connect(field_, &QLineEdit::textChanged, this, [this] {
        text_->moveCursor(QTextCursor::Start);
        find(false);
    });
    connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item != nullptr) {
            showPage(item->data(Qt::UserRole).toString());
        }
    });
    const auto key = [this](const QKeySequence& keys, auto slot) {
        connect(new QShortcut(keys, this), &QShortcut::activated, this, slot);
    };
    key(QKeySequence::Find, [this] {
        field_->setFocus(Qt::ShortcutFocusReason);
        field_->selectAll();
    });
    for (const Qt::Key each : {Qt::Key_F3, Qt::Key_Return}) {
        key(each, [this] { find(false); });
        key(Qt::SHIFT | each, [this] { find(true); });
    }
    connect(&Theme::instance(), &Theme::changed, this, &HelpWindow::renew);
    connect(&Preferences::instance(), &Preferences::changed, this, &HelpWindow::renew,
            Qt::QueuedConnection);
    text_->setFocus();
}

void HelpWindow::goTo(const QString& topic) {
    field_->clear();
    showPage(topic);
    show();
    raise();
    activateWindow();
}

void HelpWindow::renew() {
    setWindowTitle(tr("Help"));
    text_->setAccessibleName(tr("Help"));
    list_->setAccessibleName(tr("Pages of the help"));
    field_->setPlaceholderText(tr("Search this page (Ctrl+F, F3)"));
    field_->setAccessibleName(tr("Search in the help"));
    const int place = text_->verticalScrollBar()->value();
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (const QString& topic : helpTopics()) {
            auto* item = new QListWidgetItem(helpTitle(topic), list_);
            item->setData(Qt::UserRole, topic);
        }
    }
    showPage(topic_);
    text_->verticalScrollBar()->setValue(place);
}

void HelpWindow::showPage(const QString& topic) {
    topic_ = topic;
    found_->clear();
    if (!loadHelp(topic, text_->document())) {
        text_->setPlainText(tr("There is no help on this page yet."));
    }
    text_->moveCursor(QTextCursor::Start);
    const QSignalBlocker quiet(list_);
    list_->setCurrentRow(static_cast<int>(helpTopics().indexOf(topic)));
}

void HelpWindow::find(bool backwards) {
    const QString words = field_->text().trimmed();
    const QTextDocument::FindFlags way =
        backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    bool isFound = text_->find(words, way);
    if (!isFound) {
        const QTextCursor before = text_->textCursor();
        text_->moveCursor(backwards ? QTextCursor::End : QTextCursor::Start);
        isFound = text_->find(words, way);
        if (!isFound) {
            text_->setTextCursor(before);
        }
    }
    found_->setText(isFound || words.isEmpty() ? QString() : tr("nothing found"));
}

}  // namespace ravnoves
