#include "shell/start_page.h"

#include <QAbstractButton>
#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "model/case_document.h"
#include "shell/scene_list.h"
#include "shop/model/journal.h"
#include "shop/model/verdict.h"
#include "shop/model/words.h"
#include "text/plain_title.h"
#include "text/text_width.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "workshop/journal_dialog.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {

namespace {

/// Presses as every button does: a click, Space, and Enter as well.
class StartButton : public QAbstractButton {
  public:
    explicit StartButton(QWidget* parent) : QAbstractButton(parent) {
        setFocusPolicy(Qt::StrongFocus);
        setCursor(Qt::PointingHandCursor);
        setAttribute(Qt::WA_Hover);
    }

  protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
            click();
        } else {
            QAbstractButton::keyPressEvent(event);
        }
    }
    bool isMarked() const { return hasFocus() || underMouse(); }
};

/// A scene: a picture of its page, its name, what it is for.
class SceneCard : public StartButton {
  public:
    SceneCard(const SceneInfo& info, QWidget* parent)
        : StartButton(parent), summary_(info.summary), scene_(info.name) {
        setObjectName(QStringLiteral("start-") + info.name);
        setText(info.title);
        setAccessibleDescription(info.summary);
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override {
        const Texts texts = textsAt(width);
        return pictureHeight(width) + Theme::space + texts.title.height() + Theme::gap +
               texts.summary.height() + Theme::margin;
    }
    QSize sizeHint() const override { return {200, heightForWidth(200)}; }
    /// No word is cut.
    QSize minimumSizeHint() const override {
        int width = 120;
        const auto fit = [&width](const QFont& font, const QString& words) {
            for (const QString& word : words.split(QLatin1Char(' '))) {
                width = std::max(width, qCeil(textWidth(font, word)) + 2 * Theme::margin + 2);
            }
        };
        fit(titleFont(), text());
        fit(font(), summary_);
        return {width, heightForWidth(std::max(width, 200))};
    }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        const Theme& theme = Theme::instance();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(isMarked() ? theme.accent() : theme.border(), hasFocus() ? 2.0 : 1.0));
        painter.setBrush(theme.panel());
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawPixmap(QRect(Theme::margin, Theme::margin, width() - 2 * Theme::margin,
                                 pictureHeight(width()) - Theme::margin),
                           QPixmap(QStringLiteral(":/start/%1-%2.png")
                                       .arg(scene_, theme.isDark() ? QStringLiteral("dark")
                                                                   : QStringLiteral("light"))));
        int top = pictureHeight(width()) + Theme::space;
        painter.setPen(theme.text());
        painter.setFont(titleFont());
        const Texts texts = textsAt(width());
        painter.drawText(texts.title.translated(0, top), wrap, text());
        top += texts.title.height() + Theme::gap;
        painter.setFont(font());
        painter.setPen(theme.mutedText());
        painter.drawText(texts.summary.translated(0, top), wrap, summary_);
    }

  private:
    static constexpr int wrap = Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignTop;

    static int pictureHeight(int width) {
        return Theme::margin + (width - 2 * Theme::margin) * 5 / 8;
    }
    QFont titleFont() const {
        QFont bold = font();
        bold.setBold(true);
        return bold;
    }
    /// Where its texts go at a width, from the top of each.
    struct Texts {
        QRect title;
        QRect summary;
    };
    Texts textsAt(int width) const {
        return {wrapped(QFontMetrics(titleFont()), text(), width),
                wrapped(fontMetrics(), summary_, width)};
    }

    static QRect wrapped(const QFontMetrics& metrics, const QString& text, int width) {
        return metrics.boundingRect(QRect(Theme::margin, 0, width - 2 * Theme::margin, 10'000),
                                    wrap, text);
    }

    QString summary_;
    QString scene_;
};

/// A line that leads to a case: an icon, a text and a pale detail, shortened where they do not fit.
class StartLine : public StartButton {
  public:
    StartLine(const QString& icon, const QString& text, QWidget* parent) : StartButton(parent) {
        setText(plainTitle(text).replace(QLatin1Char('&'), QLatin1String("&&")));  // no mnemonic
        setIcon(themedIcon(icon));
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }

    void setInk(Ink ink) { ink_ = ink; }
    void setDetail(const QString& detail) {
        detail_ = detail;
        setAccessibleDescription(detail);
        update();
    }

    QSize sizeHint() const override {
        return {fontMetrics().horizontalAdvance(shown() + detail_) + iconSide() + 4 * Theme::space,
                fontMetrics().height() + 2 * Theme::gap};
    }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        const Theme& theme = Theme::instance();
        QPainter painter(this);
        const int side = iconSide();
        icon().paint(&painter, QRect(Theme::gap, (height() - side) / 2, side, side));
        QFont shownFont = font();
        shownFont.setUnderline(underMouse());
        painter.setFont(shownFont);
        painter.setPen((theme.*ink_)());
        const QRect room(side + 3 * Theme::gap, 0, width() - side - 4 * Theme::gap, height());
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(shown(), Qt::ElideMiddle, room.width()));
        const QRect beside =
            room.adjusted(fontMetrics().horizontalAdvance(shown()) + 2 * Theme::space, 0, 0, 0);
        if (beside.width() > 0) {
            painter.setFont(font());
            painter.setPen(theme.mutedText());
            painter.drawText(beside, Qt::AlignLeft | Qt::AlignVCenter,
                             fontMetrics().elidedText(detail_, Qt::ElideMiddle, beside.width()));
        }
        if (hasFocus()) {
            painter.setRenderHint(QPainter::Antialiasing);
            painter.setPen(QPen(theme.accent(), 2.0));
            painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
        }
    }

  private:
    QString shown() const { return text().replace(QLatin1String("&&"), QLatin1String("&")); }
    int iconSide() const { return fontMetrics().height(); }

    Ink ink_ = &Theme::accent;
    QString detail_;
};

/// A line at a place of a column; −1: its end.
StartLine* addLine(QVBoxLayout* to, int place, const QString& icon, const QString& text,
                   const char* name, const QString& tip, std::function<void()> pressed) {
    auto* line = new StartLine(icon, text, to->parentWidget());
    line->setObjectName(QLatin1String(name));
    line->setToolTip(tip);
    QObject::connect(line, &QAbstractButton::clicked, line, std::move(pressed));
    to->insertWidget(place, line);
    return line;
}

QString folderOf(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    const QString home = QDir::homePath();
    return folder == home || folder.startsWith(home + QLatin1Char('/'))
               ? QLatin1Char('~') + folder.mid(home.size())
               : folder;
}

/// When, whose, which engine, what the machine said.
QString jobText(const Words& words, const JournalJob& job) {
    QStringList said{words.day(job.date.toString(Qt::ISODate)),
                     job.numbers(),
                     job.customer,
                     listedJob(words, job).engine,
                     verdictText(words, job.verdict),
                     job.isFinished ? QString() : StartPage::tr("unfinished")};
    said.removeAll(QString());
    return said.join(QStringLiteral(" · "));
}

/// A heading, and the column below it.
QVBoxLayout* column(QWidget* box, const QString& heading) {
    QVBoxLayout* layout = columnIn(box, 0);
    auto* label = new QLabel(heading, box);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    layout->addWidget(label);
    layout->addSpacing(Theme::gap);
    return layout;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    columnIn(this)->addWidget(scroll);
    auto* content = new QWidget(scroll);
    scroll->setWidget(content);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(2 * Theme::margin, 2 * Theme::margin, 2 * Theme::margin,
                               Theme::margin);
    layout->setSpacing(Theme::margin);

    auto* heading = new QLabel(tr("What do you want to balance?"), content);
    heading->setFont(Theme::font(Theme::displaySize));
    heading->setWordWrap(true);
    layout->addWidget(heading);
    auto* purpose = new QLabel(
        tr("Ravnoves computes the inertia forces of an engine and shows what a balance shaft, a "
           "bob weight or a drilled hole changes: for engine designers, balancing shops and "
           "students."),
        content);
    purpose->setWordWrap(true);
    layout->addWidget(purpose);

    cards_ = new QGridLayout;
    cards_->setSpacing(Theme::margin);
    layout->addLayout(cards_);
    for (const SceneInfo& info : sceneList()) {
        auto* card = new SceneCard(info, content);
        cards_->addWidget(card, 0, cards_->count());
        connect(card, &QAbstractButton::clicked, this,
                [this, name = info.name] { Q_EMIT sceneRequested(name); });
    }
    layout->addSpacing(Theme::space);

    jobsBox_ = new QWidget(content);
    jobs_ = column(jobsBox_, tr("Jobs"));
    layout->addWidget(jobsBox_);
    jobsBox_->hide();
    content->installEventFilter(this);

    lists_ = new QGridLayout;
    lists_->setHorizontalSpacing(3 * Theme::margin);
    lists_->setVerticalSpacing(Theme::margin);
    layout->addLayout(lists_);
    layout->addStretch();

    recentBox_ = new QWidget(content);
    recent_ = column(recentBox_, tr("Files"));
    addLine(jobs_, -1, QStringLiteral("journal"), tr("Journal…"), "start-journal", {},
            [this] { Q_EMIT journalRequested(); });
    addLine(recent_, -1, QStringLiteral("open"), tr("Open a case…"), "start-open", {},
            [this] { Q_EMIT openDialogRequested(); });
    recent_->addStretch();
    examplesBox_ = new QWidget(content);
    QVBoxLayout* examples = column(examplesBox_, tr("Examples"));
    for (const NewCase& each : newExamples()) {
        addLine(examples, -1, QStringLiteral("scene-") + each.scene, each.question, "start-example",
                each.question + QLatin1Char('\n') + each.title,
                [this, each] { Q_EMIT newRequested(each.make()); })
            ->setDetail(each.title);
    }
    examples->addStretch();
    auto* journal = new QAction(this);
    journal->setShortcut(QKeySequence(Qt::Key_F3));
    connect(journal, &QAction::triggered, this, &StartPage::journalRequested);
    addAction(journal);
    arrange();
    showRecent();
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StartPage::showRecent() {
    constexpr int fixed = 3;  // heading, its gap, Open
    while (recent_->count() > fixed) {
        const std::unique_ptr<QLayoutItem> item(recent_->takeAt(fixed));
        delete item->widget();
    }
    QWidget* before = recent_->itemAt(fixed - 1)->widget();
    for (const QString& path : CaseDocument::recentPaths()) {
        auto* made = addLine(recent_, -1, QStringLiteral("save"), QFileInfo(path).fileName(),
                             "start-recent", path, [this, path] { Q_EMIT openRequested(path); });
        made->setDetail(folderOf(path));
        QWidget::setTabOrder(before, made);
        before = made;
    }
    recent_->addStretch();
}

void StartPage::showJobs() {
    constexpr int above = 2;  // heading and its gap; below them stands "Journal…"
    while (jobs_->count() > above + 1) {
        const std::unique_ptr<QLayoutItem> item(jobs_->takeAt(above));
        delete item->widget();
    }
    JournalQuery newest;
    newest.limit = 5;
    Journal journal(Journal::defaultPath());
    const QList<JournalJob> jobs = journal.look() ? journal.search(newest) : QList<JournalJob>();
    const Words words;
    QWidget* before = cards_->itemAt(cards_->count() - 1)->widget();
    for (const JournalJob& job : jobs) {
        const QString text = jobText(words, job);
        auto* made =
            addLine(jobs_, jobs_->count() - 1,
                    job.isFinished ? QStringLiteral("job-done") : QStringLiteral("job-new"), text,
                    "start-job", text, [this, id = job.id] { Q_EMIT jobRequested(id); });
        made->setInk(job.isFinished ? &Theme::accent : &Theme::warning);
        QWidget::setTabOrder(before, made);
        before = made;
    }
    jobsBox_->setVisible(!jobs.isEmpty());
}

void StartPage::arrange() {
    int narrowest = 0;
    for (int i = 0; i < cards_->count(); ++i) {
        narrowest = std::max(narrowest, cards_->itemAt(i)->widget()->minimumSizeHint().width());
    }
    const int room =
        std::clamp((width() - 4 * Theme::margin) / (narrowest + Theme::margin), 1, cards_->count());
    const int rows = (cards_->count() + room - 1) / room;
    const int columns = (cards_->count() + rows - 1) / rows;  // rows of one length
    int widest = 0;
    for (const QAbstractButton* example : examplesBox_->findChildren<QAbstractButton*>()) {
        widest = std::max(widest, example->sizeHint().width());
    }
    const bool beside = columns > 2 && 5 * widest <= 3 * (width() - 9 * Theme::margin);
    if (columns == columns_ && beside == areListsBeside_) {
        return;
    }
    columns_ = columns;
    areListsBeside_ = beside;
    std::vector<QWidget*> cards;
    while (cards_->count() > 0) {
        const std::unique_ptr<QLayoutItem> item(cards_->takeAt(0));
        cards.push_back(item->widget());
    }
    for (int i = 0; i < static_cast<int>(cards.size()); ++i) {
        cards_->addWidget(cards[static_cast<std::size_t>(i)], i / columns, i % columns);
        cards_->setColumnStretch(i, i < columns ? 1 : 0);
    }
    lists_->addWidget(recentBox_, 0, 0);
    lists_->addWidget(examplesBox_, beside ? 0 : 1, beside ? 1 : 0);
    lists_->setColumnStretch(0, 2);
    lists_->setColumnStretch(1, beside ? 3 : 0);
}

void StartPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void StartPage::showEvent(QShowEvent* event) {
    showRecent();
    isLooked_ = false;
    QWidget::showEvent(event);
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
    // After the first picture: a slow disk must not delay it.
    if (event->type() == QEvent::Paint && !std::exchange(isLooked_, true)) {
        QMetaObject::invokeMethod(this, &StartPage::showJobs, Qt::QueuedConnection);
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ravnoves
