#pragma once

#include <QTabBar>

namespace ravnoves {

/// The bar of the open cases, by their numbers. The program decides which have a tab, the user in
/// which order. It scrolls before its titles are too short to be distinguished.
class CaseTabs : public QTabBar {
    Q_OBJECT

  public:
    explicit CaseTabs(QWidget* parent = nullptr);

    /// In another language, or with another size of the text.
    void renew();
    /// The case of a tab; 0 without one.
    int idOf(int tab) const { return tabData(tab).toInt(); }
    /// The tab of a case, a new one at the end where it has none yet.
    int tabOf(int id, const QString& icon);
    void removeCase(int tab);
    void name(int tab, const QString& title, bool needsSaving, const QString& toolTip);
    bool hasSeveral() const { return count() > 1; }

  Q_SIGNALS:
    /// By its button, or by the middle one of the mouse.
    void closeAsked(int id);

  protected:
    QSize minimumTabSizeHint(int index) const override;
    void mouseReleaseEvent(QMouseEvent* event) override;
};

}  // namespace ravnoves
