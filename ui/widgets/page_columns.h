#pragma once

#include <QString>
#include <QTabWidget>
#include <QWidget>

class QBoxLayout;
class QGridLayout;
class QScrollArea;

namespace ravnoves {

/// The columns of a page: inputs, plots, results. Where the window is too narrow for three (or its
/// text too large), the results become the last tab of the inputs, and where it is too narrow for
/// two, the plots too; a column that is too high for the window scrolls. The widget over plots and
/// results remains visible: then it is over the tabs.
class PageColumns : public QWidget {
    Q_OBJECT

  public:
    struct Parts {
        QWidget* inputs;         ///< as wide as it says
        QTabWidget* tabs;        ///< of the inputs, or the inputs themselves
        QWidget* plots;          ///< null: results take the room
        QWidget* results;        ///< at least as wide as it says
        int resultShare = 2;     ///< of their column; the share of the plots is 5
        QWidget* top = nullptr;  ///< over plots and results
        /// Minimum width of the inputs alone: narrower they scroll sideways; 0: their size hint.
        int narrowest = 0;
    };

    explicit PageColumns(const Parts& parts, QWidget* parent = nullptr);

    /// Of the inputs of every page.
    static int inputsWidth();

    bool isFolded() const { return fold_ != Fold::None; }
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    enum class Fold { None, Results, Plots };

    Fold foldFor(int width) const;
    /// @param share  of its column in the grid; 0: it is a tab
    void place(QWidget* part, const QString& title, int column, int share);
    void placeTop(bool overAll);

    Parts parts_;
    QGridLayout* grid_;
    QScrollArea* results_;
    int resultsWidth_;  ///< that they need beside the plots
    int inputsMin_;     ///< width that they need
    int inputsAlone_;   ///< … of the inputs alone
    int inputsMax_;
    int resultsMax_;
    Fold fold_ = Fold::None;
};

/// Widgets beside each other where there is room for them, else one below the other.
class FoldingRow : public QWidget {
    Q_OBJECT

  public:
    /// @param unfoldedFrom  the width of all beside each other, designed pixels; 0: their size
    ///                      hints
    explicit FoldingRow(int unfoldedFrom, QWidget* parent = nullptr);

    void add(QWidget* widget, int share = 1);
    bool isFolded() const;
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void foldChanged(bool folded);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    int neededUnfolded() const;

    QBoxLayout* row_;
    int unfoldedFrom_;
};

/// Tabs of a page whose titles get smaller where they have no room, before they are shortened. They
/// have the height of the tab in front: another tab may scroll with the page around them, rather
/// than by itself in it. Many tabs are grouped: the bar shows the group of the tab in front, and
/// the groups before it.
class FittedTabs : public QTabWidget {
    Q_OBJECT

  public:
    explicit FittedTabs(QWidget* parent = nullptr);

    /// The tabs that are added from now on are one group.
    void beginGroup(const QString& title);
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override;
    int heightForWidth(int width) const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void tabInserted(int index) override;

  private:
    void fit();
    int groupOf(int tab) const;
    void showGroup();
    /// Of the tabs without their contents.
    int barHeight() const;

    QTabBar* groups_ = nullptr;  ///< each with its last tab in front
};

/// Adds a view to tabs so that it scrolls where it is too large; `name` is the tab's for pictures.
void addScrolledTab(QTabWidget* tabs, QWidget* view, const QString& name, const QString& title);

/// Brings the tabs to the front that a view is in.
void showTabOf(QWidget* view);

}  // namespace ravnoves
