#include "widgets/changing_label.h"

#include <gtest/gtest.h>

#include <QPaintEvent>
#include <QTest>

namespace ravnoves {
namespace {

/// Remembers what it was asked to paint.
class WatchedLabel : public ChangingLabel {
  public:
    using ChangingLabel::ChangingLabel;
    QRect painted;

  protected:
    void paintEvent(QPaintEvent* event) override {
        painted |= event->rect();
        ChangingLabel::paintEvent(event);
    }
};

class ChangingLabelTest : public testing::Test {
  protected:
    ChangingLabelTest() {
        label_.setTextInteractionFlags(Qt::NoTextInteraction);
        label_.setAttribute(Qt::WA_DontShowOnScreen);
        plain_.setTextFormat(Qt::PlainText);
        plain_.setWordWrap(true);
        label_.resize(300, 140);
        label_.show();
    }
    void settle() {
        QCoreApplication::processEvents();
        label_.painted = {};
    }
    /// As a QLabel paints the same.
    QImage expected() {
        plain_.setText(label_.text());
        plain_.setFont(label_.font());
        plain_.setAlignment(label_.alignment());
        plain_.setContentsMargins(label_.contentsMargins());
        plain_.resize(label_.size());
        return plain_.grab().toImage();
    }
    static QString words(int count) {
        return QStringLiteral("a torque of mⱼ r² ω² = 205 N·m, ").repeated(count).trimmed();
    }

    WatchedLabel label_;
    QLabel plain_;
};

TEST_F(ChangingLabelTest, IsPaintedAsALabel) {
    for (const QString& text :
         {QString(), words(1), words(9), words(3) + QLatin1Char('\n') + words(5),
          QStringLiteral("one\n\ntwo & &three\n"), QString(500, QLatin1Char('w'))}) {
        for (const Qt::Alignment up : {Qt::AlignTop, Qt::AlignVCenter, Qt::AlignBottom}) {
            for (const int pixels : {11, 13, 21}) {
                QFont font = label_.font();
                font.setPixelSize(pixels);
                label_.setFont(font);
                label_.setAlignment(up | Qt::AlignLeft);
                label_.setContentsMargins(pixels, up == Qt::AlignTop ? 3 : 0, 7, 0);
                label_.setText(text);
                for (const int width : {40, 160, 300}) {
                    label_.resize(width, 140);
                    EXPECT_EQ(label_.grab().toImage(), expected())
                        << text.toStdString() << ", " << pixels << " in " << width;
                }
            }
        }
    }
}

TEST_F(ChangingLabelTest, OnlyLinesThatChangeArePainted) {
    label_.setText(words(3) + QStringLiteral("\nfirst 1.25\n") + words(3));
    settle();
    label_.setText(words(3) + QStringLiteral("\nfirst 1.26\n") + words(3));
    QCoreApplication::processEvents();
    const int line = label_.fontMetrics().lineSpacing();
    EXPECT_GE(label_.painted.height(), line);
    EXPECT_LE(label_.painted.height(), line + 4);
    settle();
    label_.setText(label_.text());
    QCoreApplication::processEvents();
    EXPECT_TRUE(label_.painted.isEmpty());
}

TEST_F(ChangingLabelTest, NothingOfTheTextBeforeIsLeft) {
    const std::vector<QString> texts{words(2),
                                     words(2) + QStringLiteral("\nand more"),
                                     QStringLiteral("less"),
                                     words(4),
                                     words(3) + QStringLiteral(" 7 ") + words(1),
                                     QString(),
                                     QStringLiteral("x\n") + words(2)};
    for (const Qt::Alignment up : {Qt::AlignTop, Qt::AlignVCenter}) {
        label_.setAlignment(up | Qt::AlignLeft);
        label_.setText(QStringLiteral("the first"));
        settle();
        QImage kept = label_.grab().toImage();
        for (const QString& text : texts) {
            label_.painted = {};
            label_.setText(text);
            QCoreApplication::processEvents();
            const QRect painted = label_.painted;
            if (!painted.isEmpty()) {
                QPainter(&kept).drawImage(painted.topLeft(), label_.grab(painted).toImage());
            }
            EXPECT_EQ(kept, expected()) << text.toStdString();
        }
    }
}

}  // namespace
}  // namespace ravnoves
