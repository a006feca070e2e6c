#pragma once

#include <QTabBar>
#include <vector>

namespace ravnoves {

/// What a tab says of the case that it represents.
struct CaseTab {
    int id = 0;
    QString icon;
    QString name;  ///< others may have the same
    bool needsSaving = false;
    QString toolTip;
};

/// The bar of the open cases. The program decides which have a tab, the user in which order. With
/// one tab there is no bar. It scrolls before its titles are too short to be distinguished.
class CaseTabs : public QTabBar {
    Q_OBJECT

  public:
    explicit CaseTabs(QWidget* parent = nullptr);

    /// In another language, or with another size of the text.
    void renew();
    /// Has tabs of these cases alone; new ones come last.
    void arrange(const std::vector<CaseTab>& cases, int front);
    /// Says again what the tabs that are there are called.
    void name(const std::vector<CaseTab>& cases);
    /// The case of a tab; 0 without one.
    int idOf(int tab) const { return tabData(tab).toInt(); }
    bool hasSeveral() const { return count() > 1; }

  Q_SIGNALS:
    /// By its button, or by the middle one of the mouse.
    void closeAsked(int id);

  protected:
    QSize minimumTabSizeHint(int index) const override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void addCase(const CaseTab& added);
};

}  // namespace ravnoves
