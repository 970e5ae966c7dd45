#include "menus/figure_dialogs.h"

#include "document/subdocument.h"
#include "plain/plain.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace menus {

namespace {

// Lengths as the reader's country has them.
struct Measure {
    double pixels = 1; // 1/96 inch in one
    QString suffix;
};

Measure measure() {
    if (QLocale().measurementSystem() == QLocale::MetricSystem)
        return {96 / 2.54, QDialog::tr(" cm")};
    return {96, QDialog::tr(" in")};
}

QDoubleSpinBox* lengthBox(double pixels, const Measure& in, const QString& name) {
    constexpr double least = 8;
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(2);
    box->setSingleStep(0.1);
    box->setSuffix(in.suffix);
    box->setRange(least / in.pixels, document::longestLength / in.pixels);
    box->setValue(pixels / in.pixels);
    return box;
}

QDialogButtonBox* buttonsOf(QDialog& dialog) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    return buttons;
}

} // namespace

std::optional<QSizeF> askForSize(QSizeF now, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setObjectName("sizeDialog");
    dialog.setWindowTitle(QDialog::tr("Size"));
    const Measure in = measure();
    QDoubleSpinBox* width = lengthBox(now.width(), in, "width");
    QDoubleSpinBox* height = lengthBox(now.height(), in, "height");
    auto* keep = new QCheckBox(QDialog::tr("&Keep the proportions"));
    keep->setObjectName("keepRatio");
    keep->setChecked(true);
    auto* form = new QFormLayout;
    form->addRow(QDialog::tr("&Width:"), width);
    form->addRow(QDialog::tr("&Height:"), height);
    form->addRow(keep);
    // The one that is not changed by hand follows, by the proportions at the beginning.
    const double ratio = now.width() / now.height();
    bool isFollowing = false;
    const auto follow = [&](QDoubleSpinBox* other, double value) {
        if (isFollowing || !keep->isChecked())
            return;
        isFollowing = true;
        other->setValue(value);
        isFollowing = false;
    };
    QObject::connect(width, &QDoubleSpinBox::valueChanged, &dialog,
                     [&](double value) { follow(height, value / ratio); });
    QObject::connect(height, &QDoubleSpinBox::valueChanged, &dialog,
                     [&](double value) { follow(width, value * ratio); });
    QDialogButtonBox* buttons = buttonsOf(dialog);
    QPushButton* usual =
        buttons->addButton(QDialog::tr("&Usual Size"), QDialogButtonBox::ResetRole);
    usual->setObjectName("usualSize");
    usual->setAutoDefault(false);
    usual->setToolTip(QDialog::tr("The size that its medium would like"));
    bool isUsual = false;
    QObject::connect(usual, &QPushButton::clicked, &dialog, [&] {
        isUsual = true;
        dialog.accept();
    });
    auto* column = new QVBoxLayout(&dialog);
    column->addLayout(form);
    column->addWidget(buttons);
    width->selectAll();
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return isUsual ? QSizeF() : QSizeF(width->value() * in.pixels, height->value() * in.pixels);
}

std::optional<QString> askForAlternative(const QString& now, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setObjectName("alternativeDialog");
    dialog.setWindowTitle(QDialog::tr("Alternative Text"));
    auto* label = plain::label(
        QDialog::tr("What does the figure show? These words are read aloud, and stand in its place "
                    "where it cannot be shown."));
    label->setWordWrap(true);
    auto* field = new QPlainTextEdit(now);
    field->setObjectName("alternative");
    field->setTabChangesFocus(true);
    field->setMinimumWidth(380);
    constexpr int lines = 4;
    field->setFixedHeight(lines * field->fontMetrics().lineSpacing() + 12);
    field->setAccessibleName(QDialog::tr("Alternative text"));
    label->setBuddy(field);
    auto* column = new QVBoxLayout(&dialog);
    column->addWidget(label);
    column->addWidget(field);
    column->addWidget(buttonsOf(dialog));
    field->selectAll();
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return field->toPlainText().simplified();
}

} // namespace menus
