#include "shell/help_window.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QSvgRenderer>
#include <QTextBrowser>
#include <QToolButton>
#include <algorithm>

#include "text/preferences.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/dialog_size.h"
#include "widgets/layouts.h"

namespace ravnoves {

namespace {

// Of an item of the list.
constexpr int topicRole = Qt::UserRole;
constexpr int hitRole = Qt::UserRole + 1;  ///< its number on the page; none: the page itself

constexpr std::size_t mostHits = 60;  ///< of one page

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

/// Titles wrap in the width of the list; its own measure takes another one than it draws in.
class WrappedTitles : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem item = option;
        initStyleOption(&item, index);
        const auto* list = static_cast<const QListView*>(item.widget);
        const int row = list->viewport()->width() - 2 * list->spacing();
        const int margin = list->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 2;
        const QRect room(0, 0, std::max(1, row - 2 * margin), QWIDGETSIZE_MAX);
        const QRect used = item.fontMetrics.boundingRect(room, Qt::TextWordWrap, item.text);
        return {row, used.height() + 1};
    }
};

}  // namespace

HelpWindow::HelpWindow(const QString& topic, QWidget* parent) : QDialog(parent) {
    setSizeGripEnabled(true);
    resizeWithText(this, 980, 680);
    QVBoxLayout* column = columnIn(this, 0);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    field_ = new QLineEdit(this);
    field_->setObjectName(QStringLiteral("help-search"));
    field_->setClearButtonEnabled(true);
    field_->installEventFilter(this);
    row->addWidget(field_, 1);
    count_ = new QLabel(this);
    count_->setObjectName(QStringLiteral("help-count"));
    row->addWidget(count_);
    const auto button = [&](Qt::ArrowType arrow, const QString& name, int by) {
        auto* made = new QToolButton(this);
        made->setArrowType(arrow);
        made->setObjectName(name);
        made->setAutoRaise(true);
        made->setEnabled(false);
        connect(made, &QToolButton::clicked, this, [this, by] { step(by); });
        row->addWidget(made);
        return made;
    };
    previous_ = button(Qt::UpArrow, QStringLiteral("help-previous"), -1);
    next_ = button(Qt::DownArrow, QStringLiteral("help-next"), 1);
    column->addLayout(row);

    auto* halves = new QSplitter(this);
    halves->setChildrenCollapsible(false);
    list_ = new QListWidget(halves);
    list_->setObjectName(QStringLiteral("help-list"));
    list_->setWordWrap(true);
    list_->setItemDelegate(new WrappedTitles(list_));
    list_->setResizeMode(QListView::Adjust);
    list_->setTextElideMode(Qt::ElideNone);  // a title that wraps is read whole
    list_->setSpacing(2);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    text_ = new HelpText(halves);
    text_->setFrameShape(QFrame::NoFrame);
    text_->setSearchPaths({QStringLiteral(":/help")});  // of the pictures
    halves->setStretchFactor(1, 1);
    halves->setSizes({Theme::withText(250), Theme::withText(730)});
    column->addWidget(halves, 1);

    topic_ = topic;
    renew();
    connect(field_, &QLineEdit::textChanged, this, &HelpWindow::search);
    connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item != nullptr) {
            showItem(item);
        }
    });
    const auto key = [this](const QKeySequence& keys, auto slot) {
        connect(new QShortcut(keys, this), &QShortcut::activated, this, slot);
    };
    key(QKeySequence::Find, [this] {
        field_->setFocus(Qt::ShortcutFocusReason);
        field_->selectAll();
    });
    key(Qt::Key_F3, [this] { step(1); });
    key(Qt::SHIFT | Qt::Key_F3, [this] { step(-1); });
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
    field_->setPlaceholderText(tr("Search all pages (Ctrl+F)"));
    field_->setAccessibleName(tr("Search in the help"));
    const auto name = [](QToolButton* button, const QString& tip) {
        button->setToolTip(tip);
        button->setAccessibleName(tip);
    };
    name(previous_, tr("Previous (Shift+F3)"));
    name(next_, tr("Next (F3)"));
    const int place = text_->verticalScrollBar()->value();
    readPages();
    showPage(topic_);
    search();
    if (field_->text().trimmed().isEmpty()) {
        text_->verticalScrollBar()->setValue(place);
    }
}

HelpWindow::~HelpWindow() {
    text_->setDocument(nullptr);  // it is of a page, and they go first
}

/// Read while nothing shows them: a document in view is laid out anew at every paragraph.
void HelpWindow::readPages() {
    text_->setExtraSelections({});  // they hold on to the pages that go
    hit_ = nullptr;
    text_->setDocument(nullptr);
    pages_.clear();
    for (const QString& topic : helpTopics()) {
        Page page{topic, {}, std::make_unique<QTextDocument>(), {}};
        page.text->setDocumentMargin(Theme::margin * 2);
        page.text->setDefaultFont(Theme::font(Theme::baseSize + 1));
        page.text->setResourceProvider([this](const QUrl& name) {
            return text_->loadResource(QTextDocument::ImageResource, name);
        });
        if (loadHelp(topic, page.text.get())) {
            page.title = helpTitle(*page.text);
            pages_.push_back(std::move(page));
        }
    }
}

const HelpWindow::Page* HelpWindow::page(const QString& topic) const {
    const auto found = std::find_if(pages_.begin(), pages_.end(),
                                    [&](const Page& each) { return each.topic == topic; });
    return found == pages_.end() ? nullptr : &*found;
}

void HelpWindow::showPage(const QString& topic) {
    topic_ = topic;
    const Page* shown = page(topic);
    text_->setDocument(shown != nullptr ? shown->text.get() : nullptr);
    if (shown == nullptr) {
        text_->setPlainText(tr("There is no help on this page yet."));
    }
    text_->moveCursor(QTextCursor::Start);
    if (field_->text().trimmed().isEmpty()) {
        for (int i = 0; i < list_->count(); ++i) {
            if (list_->item(i)->data(topicRole) == topic) {
                const QSignalBlocker quiet(list_);
                list_->setCurrentRow(i);
            }
        }
    }
}

void HelpWindow::search() {
    hit_ = nullptr;
    std::size_t found = 0;
    bool areMore = false;
    for (Page& each : pages_) {
        each.hits = findInHelp(*each.text, field_->text());
        // A single letter stands everywhere; nobody goes through thousands.
        if (each.hits.size() > mostHits) {
            each.hits.resize(mostHits);
            areMore = true;
        }
        found += each.hits.size();
    }
    const bool asked = !field_->text().trimmed().isEmpty();
    fillList();
    previous_->setEnabled(found > 0);
    next_->setEnabled(found > 0);
    count_->setText(!asked ? QString()
                    : found == 0
                        ? tr("nothing found")
                        : QString::number(found) + (areMore ? QStringLiteral("+") : QString()));
    markHits();
    if (found > 0) {
        // The page that is open, if it has one; else the first that has.
        const Page* open = page(topic_);
        const bool here = open != nullptr && !open->hits.empty();
        for (int i = 0; i < list_->count(); ++i) {
            const QListWidgetItem* item = list_->item(i);
            if (item->data(hitRole).isValid() && (!here || item->data(topicRole) == topic_)) {
                list_->setCurrentRow(i);
                break;
            }
        }
    }
}

void HelpWindow::fillList() {
    const QSignalBlocker quiet(list_);
    list_->clear();
    const bool asked = !field_->text().trimmed().isEmpty();
    for (const Page& each : pages_) {
        if (asked && each.hits.empty()) {
            continue;
        }
        auto* heading = new QListWidgetItem(each.title, list_);
        heading->setData(topicRole, each.topic);
        if (!asked) {
            if (each.topic == topic_) {
                list_->setCurrentItem(heading);
            }
            continue;
        }
        QFont bold = list_->font();
        bold.setBold(true);
        heading->setFont(bold);
        heading->setFlags(Qt::ItemIsEnabled);
        for (std::size_t i = 0; i < each.hits.size(); ++i) {
            auto* item = new QListWidgetItem(each.hits[i].context, list_);
            item->setData(topicRole, each.topic);
            item->setData(hitRole, static_cast<int>(i));
        }
    }
}

void HelpWindow::showItem(const QListWidgetItem* item) {
    const QString topic = item->data(topicRole).toString();
    if (topic != topic_) {
        showPage(topic);
    }
    hit_ = nullptr;
    const Page* open = page(topic);
    if (const QVariant number = item->data(hitRole); number.isValid() && open != nullptr) {
        hit_ = &open->hits[number.value<std::size_t>()];
        QTextCursor cursor(text_->document());
        cursor.setPosition(hit_->position);
        text_->setTextCursor(cursor);
        // Not at the edge: what stands around it is read as well.
        QScrollBar* bar = text_->verticalScrollBar();
        bar->setValue(bar->value() + text_->cursorRect().top() - text_->viewport()->height() / 3);
    }
    markHits();
}

void HelpWindow::step(int by) {
    for (int i = 1; i <= list_->count(); ++i) {
        const int row =
            ((list_->currentRow() + by * i) % list_->count() + list_->count()) % list_->count();
        if (list_->item(row)->data(hitRole).isValid()) {
            list_->setCurrentRow(row);
            return;
        }
    }
}

void HelpWindow::markHits() {
    QList<QTextEdit::ExtraSelection> marks;
    if (const Page* open = page(topic_)) {
        const Theme& theme = Theme::instance();
        for (const HelpHit& hit : open->hits) {
            QTextEdit::ExtraSelection mark;
            mark.cursor = QTextCursor(text_->document());
            mark.cursor.setPosition(hit.position);
            mark.cursor.setPosition(hit.position + hit.length, QTextCursor::KeepAnchor);
            const bool present = &hit == hit_;
            mark.format.setBackground(present ? theme.accent() : theme.grid());
            mark.format.setForeground(present ? theme.panel() : theme.text());
            marks << mark;
        }
    }
    text_->setExtraSelections(marks);
}

bool HelpWindow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == field_ && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        switch (key->key()) {
            case Qt::Key_Return:
            case Qt::Key_Enter:
                step(key->modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1);
                return true;
            case Qt::Key_Down:
            case Qt::Key_Up:
                step(key->key() == Qt::Key_Down ? 1 : -1);
                return true;
            case Qt::Key_Escape:
                if (!field_->text().isEmpty()) {
                    field_->clear();
                    return true;
                }
                break;
            default:
                break;
        }
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace ravnoves
