#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;

namespace ravnoves {

/// Name and logo of the shop, as the job cards have them.
class ShopDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ShopDialog(QWidget* parent = nullptr);

    void accept() override;

  private:
    void showLogo();

    QLineEdit* name_;
    QString logo_;
    QLabel* picture_;
};

}  // namespace ravnoves
