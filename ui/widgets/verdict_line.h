#pragma once

#include <QWidget>

#include "case-file/verdict.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace ravnoves {

/// The first line of a page: how good or bad the answer is (sign, word and colour), the verdict,
/// and at most one button for the next sensible step. The sign's shape and the word show the
/// severity without colour.
class VerdictLine : public QWidget {
    Q_OBJECT

  public:
    explicit VerdictLine(QWidget* parent = nullptr);

    /// @param act  what the button says; without it there is no button
    void show(const Verdict& verdict, const QString& act = {});
    /// As read out and copied: "Warning: …".
    QString text() const;

  Q_SIGNALS:
    /// The button was pressed.
    void acted();

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// In the present theme and font.
    void dress();
    /// Sign and button are beside the text, or above and below where it would be a narrow column.
    void arrange();

    Severity severity_ = Severity::good;
    QBoxLayout* line_;  ///< sign and text, then the button
    QBoxLayout* row_;   ///< sign, then the text
    QLabel* sign_;
    QLabel* word_;
    QLabel* text_;
    QPushButton* act_;
};

/// The word of a severity, in the language of the program.
QString severityName(Severity severity);

}  // namespace ravnoves
