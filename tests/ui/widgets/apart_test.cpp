
#include <gtest/gtest.h>

#include <QClipboard>
#include <QTest>
#include <QVBoxLayout>

#include "comes.h"
#include "plot/plot_view.h"
#include "widgets/answer_label.h"

namespace ravnoves {
namespace {

/// Counts how often the page around the label is laid out again.
class LayoutCount : public QWidget {
  public:
    using QWidget::QWidget;
    int count = 0;

  protected:
    bool event(QEvent* event) override {
        count += event->type() == QEvent::LayoutRequest ? 1 : 0;
        return QWidget::event(event);
    }
};

class ApartTest : public testing::Test {
  protected:
    ApartTest() {
        auto* column = new QVBoxLayout(&page_);
        apart_ = new Apart(label_, &page_);
        column->addWidget(apart_);
        column->addStretch();
        page_.resize(300, 400);
        label_->setText(QStringLiteral("Minimum range 1000.0 N·m at 50.65°"));
        page_.show();
        settle();
    }
    void settle() {
        QTest::qWait(150);
        page_.count = 0;
    }

    bool isFitted() const { return label_->height() == label_->heightForWidth(label_->width()); }

    LayoutCount page_;
    AnswerLabel* label_ = new AnswerLabel;
    Apart* apart_ = nullptr;
};

TEST_F(ApartTest, OtherDigitsLeaveThePageAlone) {
    const int height = label_->height();
    label_->setText(QStringLiteral("Minimum range 1066.7 N·m at 49.12°"));
    QTest::qWait(150);
    EXPECT_EQ(page_.count, 0);
    EXPECT_EQ(label_->height(), height);
}

TEST_F(ApartTest, ALongerTextGetsItsRoom) {
    const int height = label_->height();
    label_->setText(
        QStringLiteral("Minimum range 1066.7 N·m at 49.12°, which does not fit: the counterweight "
                       "of the shaft meets the cylinder"));
    EXPECT_TRUE(test::comes([&] { return label_->height() > height && isFitted(); }));
    EXPECT_GT(page_.count, 0);
}

TEST_F(ApartTest, ATextOfTheSameLengthThatWrapsElsewhereIsFittedAtRest) {
    const int length = static_cast<int>(label_->text().size());
    label_->setText(QString(length, QLatin1Char('W')).replace(length / 2, 1, QLatin1Char(' ')));
    EXPECT_TRUE(test::comes([&] { return isFitted(); }));
}

TEST_F(ApartTest, UnderAHandThatDragsItGivesNoRoomBack) {
    const QString line = QStringLiteral("a text of several words ");
    label_->setText(line.repeated(9));
    settle();
    const int high = apart_->height();
    PlotView::setSteady(true);
    label_->setText(line);
    settle();
    EXPECT_EQ(apart_->height(), high);
    apart_->updateGeometry();  // the page is laid out for something else
    settle();
    EXPECT_EQ(apart_->height(), high);
    label_->setText(line.repeated(20));  // what it needs it has
    EXPECT_TRUE(test::comes([&] { return apart_->height() > high; }));
    PlotView::setSteady(false);
    label_->setText(line);
    EXPECT_TRUE(test::comes([&] { return apart_->height() < high; }));
}

TEST_F(ApartTest, ATextThatComesWhileThePageIsHiddenGetsItsRoom) {
    const int height = label_->height();
    const QString before = label_->text();
    page_.hide();
    label_->setText(before + QLatin1Char('\n') + before + QLatin1Char('\n') + before);
    page_.show();
    QApplication::processEvents();
    EXPECT_GT(label_->height(), height);
    EXPECT_EQ(label_->height(), label_->heightForWidth(label_->width()));
    page_.hide();
    label_->setText(before);
    page_.show();
    QApplication::processEvents();
    EXPECT_EQ(label_->height(), height);
    // Nothing is laid out again for a text that is as it was.
    settle();
    page_.hide();
    page_.show();
    QApplication::processEvents();
    EXPECT_EQ(page_.count, 0);
}

TEST_F(ApartTest, ItsMenuCopiesTheText) {
    ASSERT_EQ(label_->contextMenuPolicy(), Qt::ActionsContextMenu);
    label_->setText(QStringLiteral("Mass 1.25 kg\nRadius 40 mm"));
    label_->actions().constFirst()->trigger();
    EXPECT_EQ(QGuiApplication::clipboard()->text(), label_->text());
}

}  // namespace
}  // namespace ravnoves
