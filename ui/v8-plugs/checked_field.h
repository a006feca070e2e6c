#pragma once

#include <QLineEdit>
#include <functional>

namespace ravnoves {

/// A field for text that must have a form (a date, a thread). What has not is never passed on and
/// never thrown away: the text stays, the frame turns red, trouble() says what is wrong.
class CheckedField : public QLineEdit {
    Q_OBJECT

  public:
    /// Says what is wrong with a text; empty where nothing is. An empty text is not asked about.
    using Check = std::function<QString(const QString& text)>;

    explicit CheckedField(Check check, QWidget* parent = nullptr);

    /// Shows a text unless the user is at something not yet valid.
    void setValue(const QString& text);
    QString trouble() const { return trouble_; }

  Q_SIGNALS:
    /// The user typed something valid, or emptied the field.
    void valueEdited(const QString& text);
    void troubleChanged(const QString& trouble);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void readText();
    void setTrouble(const QString& trouble);

    Check check_;
    QString trouble_;
};

}  // namespace ravnoves
