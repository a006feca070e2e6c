#include "shop/shop_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPixmap>
#include <QPushButton>

#include "pictures/file_dialogs.h"
#include "shop/shop.h"
#include "theme/theme.h"
#include "widgets/text_length.h"

namespace ravnoves {

ShopDialog::ShopDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Shop on the job card"));
    const Shop shop = Shop::kept();
    logo_ = shop.logo;
    auto* form = new QFormLayout(this);
    name_ = new QLineEdit(shop.name, this);
    name_->setObjectName(QStringLiteral("shop_name"));
    limitLength(name_, 80);
    name_->setMinimumWidth(Theme::withText(320));
    form->addRow(tr("&Name of the shop"), name_);
    auto* row = new QHBoxLayout;
    picture_ = new QLabel(this);
    picture_->setObjectName(QStringLiteral("shop_logo"));
    row->addWidget(picture_, 1);
    auto* choose = new QPushButton(tr("&Choose…"), this);
    choose->setObjectName(QStringLiteral("shop_choose"));
    row->addWidget(choose);
    auto* none = new QPushButton(tr("N&one"), this);
    for (QPushButton* button : {choose, none}) {
        button->setAutoDefault(false);  // Enter is OK
    }
    row->addWidget(none);
    form->addRow(tr("Logo"), row);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    form->addRow(buttons);
    connect(choose, &QPushButton::clicked, this, [this] {
        const QString file = askOpenPath(this, tr("Logo of the shop"), {},
                                         tr("Pictures (*.png *.jpg *.jpeg *.svg)"));
        if (!file.isEmpty() && Shop::read(file).isNull()) {
            QMessageBox::warning(this, windowTitle(), tr("%1 is not a picture.").arg(file));
        } else if (!file.isEmpty()) {
            logo_ = file;
            showLogo();
        }
    });
    connect(none, &QPushButton::clicked, this, [this] {
        logo_.clear();
        showLogo();
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &ShopDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showLogo();
}

void ShopDialog::showLogo() {
    const QPixmap logo = QPixmap::fromImage(Shop::read(logo_));
    if (logo.isNull()) {
        picture_->setText(logo_.isEmpty() ? tr("none") : tr("%1 cannot be read").arg(logo_));
    } else {
        picture_->setPixmap(logo.scaled(Theme::withText(160), Theme::withText(48),
                                        Qt::KeepAspectRatio, Qt::SmoothTransformation));
    }
}

void ShopDialog::accept() {
    const QString trouble = Shop{name_->text().trimmed(), logo_}.keep();
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, windowTitle(), trouble);
    }
    QDialog::accept();
}

}  // namespace ravnoves
