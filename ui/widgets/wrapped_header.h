#pragma once

#include <QHeaderView>
#include <QStringList>

namespace ravnoves {

/// Headings of columns that wrap in a narrow column.
class WrappedHeader : public QHeaderView {
    Q_OBJECT

  public:
    explicit WrappedHeader(QWidget* parent = nullptr);

    /// The width of a heading: of its longest word, or of all words.
    int widthOf(const QString& heading, bool wraps) const;
    /// Takes the height that the headings need now.
    void fitLines();
    QSize sizeHint() const override;

  protected:
    void initStyleOptionForIndex(QStyleOptionHeader* option, int section) const override;

  private:
    QStringList linesOf(int section) const;

    int lines_ = 1;  ///< that its place has room for
};

}  // namespace ravnoves
