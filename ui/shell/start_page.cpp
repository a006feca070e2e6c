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
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>

#include "model/case_document.h"
#include "shell/scene_list.h"
#include "shop/model/journal.h"
#include "shop/model/verdict.h"
#include "shop/model/words.h"
#include "text/plain_title.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "workshop/journal_dialog.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {

namespace {

/// What is pressed as every button is: by a click, Space, and Enter as well. Labels over it show
/// it.
class StartButton : public QAbstractButton {
  public:
    StartButton(const QString& name, const QString& text, QWidget* parent)
        : QAbstractButton(parent) {
        setObjectName(name);
        setText(QString(text).replace(QLatin1Char('&'), QLatin1String("&&")));  // no mnemonic
        setFocusPolicy(Qt::StrongFocus);
        setCursor(Qt::PointingHandCursor);
        setAttribute(Qt::WA_Hover);
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
        setBackgroundRole(QPalette::Window);  // its labels have their own inks
    }

    QLabel* addLabel(const QString& text, Ink ink) {
        auto* label = new QLabel(text, this);
        label->setTextFormat(Qt::PlainText);
        colourText(label, ink);
        layout()->addWidget(label);
        return label;
    }

  protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
            click();
        } else {
            QAbstractButton::keyPressEvent(event);
        }
    }
    void paintEvent(QPaintEvent* /*event*/) override {
        const Theme& theme = Theme::instance();
        const bool isCard = icon().isNull();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        if (!isCard) {
            const int side = fontMetrics().height();
            icon().paint(&painter, QRect(Theme::gap, (height() - side) / 2, side, side));
        }
        const bool isMarked = hasFocus() || underMouse();
        painter.setPen(hasFocus() || isCard ? QPen(isMarked ? theme.accent() : theme.border(),
                                                   hasFocus() ? 2.0 : 1.0)
                                            : Qt::NoPen);
        painter.setBrush(isCard ? QBrush(theme.panel()) : QBrush());
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
};

/// A picture of a scene's page.
class ScenePicture : public QWidget {
  public:
    ScenePicture(const QString& scene, QWidget* parent) : QWidget(parent), scene_(scene) {
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
        setMinimumWidth(100);
    }
    int heightForWidth(int width) const override { return width * 5 / 8; }
    QSize sizeHint() const override { return {180, heightForWidth(180)}; }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        const QString theme =
            Theme::instance().isDark() ? QStringLiteral("dark") : QStringLiteral("light");
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawPixmap(rect(), QPixmap(QStringLiteral(":/start/%1-%2.png").arg(scene_, theme)));
    }

  private:
    QString scene_;
};

/// A scene: a picture of its page, its name, what it is for.
StartButton* sceneCard(const SceneInfo& info, QWidget* parent) {
    auto* card = new StartButton(QStringLiteral("start-") + info.name, info.title, parent);
    card->setAccessibleDescription(info.summary);
    QVBoxLayout* column =
        columnIn(card, Theme::gap, {Theme::margin, Theme::margin, Theme::margin, Theme::margin});
    column->addWidget(new ScenePicture(info.name, card));
    QLabel* title = card->addLabel(info.title, &Theme::text);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    title->setWordWrap(true);
    card->addLabel(info.summary, &Theme::mutedText)->setWordWrap(true);
    column->addStretch();
    return card;
}

/// A line that leads to a case: an icon, a text and a pale detail, cut where they do not fit.
/// @param place  in the column; −1: its end
StartButton* addLine(QVBoxLayout* to, int place, const QString& icon, const QString& text,
                     const QString& detail, const char* name, const QString& tip,
                     std::function<void()> pressed, Ink ink = &Theme::accent) {
    const QString plain = plainTitle(text);
    auto* line = new StartButton(QLatin1String(name), plain, to->parentWidget());
    line->setIcon(themedIcon(icon));
    line->setAccessibleDescription(detail);
    line->setToolTip(tip);
    QHBoxLayout* row =
        rowIn(line, 2 * Theme::space,
              {line->fontMetrics().height() + 3 * Theme::gap, Theme::gap, Theme::gap, Theme::gap});
    line->addLabel(plain, ink)->setMinimumWidth(1);
    line->addLabel(detail, &Theme::mutedText)
        ->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->setStretch(1, 1);
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

    grid_ = new QGridLayout;
    grid_->setSpacing(Theme::margin);
    layout->addLayout(grid_);
    for (const SceneInfo& info : sceneList()) {
        StartButton* card = sceneCard(info, content);
        cards_.push_back(card);
        connect(card, &QAbstractButton::clicked, this,
                [this, name = info.name] { Q_EMIT sceneRequested(name); });
    }
    layout->addSpacing(Theme::space);

    jobsBox_ = new QWidget(content);
    jobs_ = column(jobsBox_, tr("Jobs"));
    layout->addWidget(jobsBox_);
    jobsBox_->hide();
    addLine(jobs_, -1, QStringLiteral("journal"), tr("Journal…"), {}, "start-journal", {},
            [this] { Q_EMIT journalRequested(); });
    QTimer::singleShot(0, this, &StartPage::showJobs);  // a slow disk must not delay the rest

    auto* recentBox = new QWidget(content);
    QVBoxLayout* recent = column(recentBox, tr("Files"));
    addLine(recent, -1, QStringLiteral("open"), tr("Open a case…"), {}, "start-open", {},
            [this] { Q_EMIT openDialogRequested(); });
    for (const QString& path : CaseDocument::recentPaths()) {
        addLine(recent, -1, QStringLiteral("save"), QFileInfo(path).fileName(), folderOf(path),
                "start-recent", path, [this, path] { Q_EMIT openRequested(path); });
    }
    layout->addWidget(recentBox);
    auto* examplesBox = new QWidget(content);
    QVBoxLayout* examples = column(examplesBox, tr("Examples"));
    for (const NewCase& each : newCases()) {
        if (!each.question.isEmpty()) {
            addLine(examples, -1, QStringLiteral("scene-") + each.scene, each.question, each.title,
                    "start-example", each.question + QLatin1Char('\n') + each.title,
                    [this, each] { Q_EMIT newRequested(each.make()); });
        }
    }
    layout->addWidget(examplesBox);
    layout->addStretch();
    auto* journal = new QAction(this);
    journal->setShortcut(QKeySequence(Qt::Key_F3));
    connect(journal, &QAction::triggered, this, &StartPage::journalRequested);
    addAction(journal);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StartPage::showJobs() {
    JournalQuery newest;
    newest.limit = 5;
    Journal journal(Journal::defaultPath());
    const QList<JournalJob> jobs = journal.look() ? journal.search(newest) : QList<JournalJob>();
    const Words words;
    QWidget* before = cards_.back();
    for (const JournalJob& job : jobs) {
        const QString text = jobText(words, job);
        auto* made = addLine(
            jobs_, jobs_->count() - 1,
            job.isFinished ? QStringLiteral("job-done") : QStringLiteral("job-new"), text, {},
            "start-job", text, [this, id = job.id] { Q_EMIT jobRequested(id); },
            job.isFinished ? &Theme::accent : &Theme::warning);
        QWidget::setTabOrder(before, made);
        before = made;
    }
    jobsBox_->setVisible(!jobs.isEmpty());
}

/// Cards in rows of one length.
void StartPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const int count = static_cast<int>(cards_.size());
    int narrowest = 0;
    for (const QWidget* card : cards_) {
        narrowest = std::max(narrowest, card->minimumSizeHint().width());
    }
    const int room =
        std::clamp((width() - 4 * Theme::margin) / (narrowest + Theme::margin), 1, count);
    const int rows = (count + room - 1) / room;
    const int columns = (count + rows - 1) / rows;
    for (int i = 0; i < count; ++i) {
        grid_->addWidget(cards_[static_cast<std::size_t>(i)], i / columns, i % columns);
        grid_->setColumnStretch(i, i < columns ? 1 : 0);
    }
}

}  // namespace ravnoves
