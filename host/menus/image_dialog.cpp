#include "menus/image_dialog.h"

#include "plain/plain.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace menus {

std::optional<ImageWishes> askAboutImage(const QString& title, const QImage& picture,
                                         const ImageWishes& now, bool hasCaption, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setObjectName("imageDialog");
    dialog.setWindowTitle(plain::title(title));
    auto* form = new QFormLayout(&dialog);
    if (!picture.isNull()) {
        auto* shown = plain::label();
        constexpr int side = 200;
        shown->setPixmap(QPixmap::fromImage(
            picture.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
        shown->setAlignment(Qt::AlignCenter);
        form->addRow(shown);
    }
    auto* alternative = new QLineEdit(now.alternative);
    alternative->setObjectName("alternative");
    alternative->setPlaceholderText(QDialog::tr("What does it show?"));
    alternative->setToolTip(
        QDialog::tr("For readers who do not see it, and where the picture is missing."));
    constexpr int fieldWidth = 320;
    alternative->setMinimumWidth(fieldWidth);
    form->addRow(QDialog::tr("&Alternative text:"), alternative);
    auto* caption = new QLineEdit(now.caption);
    caption->setObjectName("caption");
    caption->setPlaceholderText(QDialog::tr("none"));
    if (hasCaption)
        form->addRow(QDialog::tr("&Caption:"), caption);
    else
        caption->hide();
    constexpr double toMillimetres = 25.4 / 96, least = 4, most = 1000, usual = 80;
    auto* automatic = new QCheckBox(QDialog::tr("Its o&wn, if there is room"));
    automatic->setObjectName("automatic");
    automatic->setChecked(now.width <= 0);
    auto* width = new QDoubleSpinBox;
    width->setObjectName("width");
    width->setRange(least, most);
    width->setDecimals(1);
    width->setSuffix(QDialog::tr(" mm"));
    width->setValue(now.width > 0 ? now.width * toMillimetres : usual);
    width->setEnabled(now.width > 0);
    QObject::connect(automatic, &QCheckBox::toggled, width, &QWidget::setDisabled);
    form->addRow(QDialog::tr("Width:"), automatic);
    form->addRow(QString(), width);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    form->addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (!hasCaption)
        caption->setParent(&dialog);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    const int pixels = qRound(width->value() / toMillimetres);
    return ImageWishes{alternative->text().simplified(), caption->text().simplified(),
                       automatic->isChecked() ? 0 : pixels};
}

} // namespace menus
