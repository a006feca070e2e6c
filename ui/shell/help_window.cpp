#include "shell/help_window.h"

#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QRegularExpression>
#include <QShortcut>
#include <QSplitter>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextFrame>
#include <QTextList>
#include <QTextTable>

#include "shell/scene_list.h"
#include "text/language.h"
#include "text/preferences.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "widgets/layouts.h"

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

void layOutTables(QTextFrame* frame) {
    for (QTextFrame* child : frame->childFrames()) {
        if (auto* table = qobject_cast<QTextTable*>(child)) {
            QTextTableFormat format = table->format();
            format.setCellPadding(Theme::gap);
            format.setCellSpacing(0);
            format.setBorder(1);
            format.setBorderCollapse(true);
            format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
            format.setBorderBrush(Theme::instance().border());
            format.setTopMargin(Theme::gap);
            format.setBottomMargin(Theme::margin);
            table->setFormat(format);
        }
        layOutTables(child);
    }
}

/// Room between paragraphs and lines; Markdown leaves that to who shows it.
void layOut(QTextDocument* document) {
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        QTextBlockFormat format = block.blockFormat();
        format.setLineHeight(120, QTextBlockFormat::ProportionalHeight);
        if (cursor.currentTable() == nullptr) {
            const bool heading = format.headingLevel() > 0;
            const bool code = format.hasProperty(QTextFormat::BlockCodeFence) ||
                              format.hasProperty(QTextFormat::BlockCodeLanguage);
            const bool listGoesOn =
                block.textList() != nullptr && block.next().textList() == block.textList();
            format.setTopMargin(heading && block.blockNumber() > 0 ? 2 * Theme::margin : 0);
            format.setBottomMargin(heading      ? Theme::space
                                   : code       ? 0
                                   : listGoesOn ? Theme::gap
                                                : Theme::margin);
        }
        cursor.setBlockFormat(format);
    }
    layOutTables(document->rootFrame());
}

QString markdown(const QString& topic) {
    QFile file(QStringLiteral(":/help/%1.%2.md").arg(topic, currentLanguage()));
    if (!file.exists()) {
        file.setFileName(QStringLiteral(":/help/%1.md").arg(topic));
    }
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

HelpWindow::HelpWindow(const QString& topic, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Help"));
    setSizeGripEnabled(true);
    resizeWithText(this, 980, 680);
    QVBoxLayout* column = columnIn(this, 0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    field_ = new QLineEdit(this);
    field_->setObjectName(QStringLiteral("help-search"));
    field_->setClearButtonEnabled(true);
    field_->setPlaceholderText(tr("Search this page (Ctrl+F, F3)"));
    field_->setAccessibleName(tr("Search in the help"));
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
    list_->setAccessibleName(tr("Pages of the help"));
    list_->setWordWrap(true);
    list_->setResizeMode(QListView::Adjust);
    list_->setSpacing(2);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    text_ = new HelpText(halves);
    text_->setAccessibleName(tr("Help"));
    text_->setFrameShape(QFrame::NoFrame);
    text_->setSearchPaths({QStringLiteral(":/help")});
    text_->document()->setDocumentMargin(Theme::margin * 2);
    text_->document()->setDefaultFont(Theme::font(Theme::baseSize + 1));
    halves->setStretchFactor(1, 1);
    halves->setSizes({Theme::withText(250), Theme::withText(730)});
    column->addWidget(halves, 1);

    QStringList topics;
    for (const SceneInfo& info : sceneList()) {
        topics << info.name;
    }
    topics << QStringLiteral("case-files") << QStringLiteral("variants")
           << QStringLiteral("tolerances") << QStringLiteral("keys");
    static const QRegularExpression signs(QStringLiteral("^#+ *"));
    for (const QString& each : topics) {
        const QString heading = markdown(each).section(QLatin1Char('\n'), 0, 0).remove(signs);
        auto* item = new QListWidgetItem(heading, list_);
        item->setData(Qt::UserRole, each);
    }
    showPage(topic);
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
    // What it shows is in one language and in the colours of one theme.
    connect(&Theme::instance(), &Theme::changed, this, &QDialog::close);
    connect(&Preferences::instance(), &Preferences::changed, this, &QDialog::close);
    text_->setFocus();
}

void HelpWindow::goTo(const QString& topic) {
    field_->clear();
    showPage(topic);
    show();
    raise();
    activateWindow();
}

void HelpWindow::showPage(const QString& topic) {
    found_->clear();
    const QString text = markdown(topic);
    QTextDocument* document = text_->document();
    document->clear();  // with its pictures, which are in the colours of the theme
    // Else tables are laid out again at each piece inserted.
    document->setLayoutEnabled(false);
    document->setMarkdown(text);
    layOut(document);
    document->setLayoutEnabled(true);
    if (text.isEmpty()) {
        text_->setPlainText(tr("There is no help on this page yet."));
    }
    text_->moveCursor(QTextCursor::Start);
    const QSignalBlocker quiet(list_);
    const QAbstractItemModel* topics = list_->model();
    list_->setCurrentIndex(
        topics->match(topics->index(0, 0), Qt::UserRole, topic, 1, Qt::MatchExactly).value(0));
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
