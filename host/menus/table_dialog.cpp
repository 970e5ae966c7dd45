#include "menus/table_dialog.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>

namespace menus {

namespace {

template <class Box, class Number>
Box* numberBox(const char* name, Number least, Number most, Number now) {
    auto* box = new Box;
    box->setObjectName(name);
    box->setRange(least, most);
    box->setValue(now);
    return box;
}

bool isAccepted(QDialog& dialog, QFormLayout& form) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    form.addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    return dialog.exec() == QDialog::Accepted;
}

} // namespace

std::optional<authoring::NewTable> askForTable(bool hasHeaders, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setObjectName("tableDialog");
    dialog.setWindowTitle(QDialog::tr("Insert Table"));
    auto* form = new QFormLayout(&dialog);
    constexpr int mostRows = 500, mostColumns = 50, rowsFirst = 3, columnsFirst = 3;
    auto* columns = numberBox<QSpinBox>("columns", 1, mostColumns, columnsFirst);
    auto* rows = numberBox<QSpinBox>("rows", 1, mostRows, rowsFirst);
    auto* header = new QCheckBox(QDialog::tr("The first row is a &header"));
    header->setObjectName("header");
    header->setToolTip(QDialog::tr("It stands again on each page that the table goes on on."));
    header->setChecked(hasHeaders);
    auto* caption = new QLineEdit;
    caption->setObjectName("caption");
    caption->setPlaceholderText(QDialog::tr("none"));
    constexpr int captionWidth = 280;
    caption->setMinimumWidth(captionWidth);
    form->addRow(QDialog::tr("&Columns:"), columns);
    form->addRow(QDialog::tr("&Rows:"), rows);
    if (hasHeaders)
        form->addRow(QString(), header);
    form->addRow(QDialog::tr("Ca&ption:"), caption);
    columns->selectAll();
    if (!isAccepted(dialog, *form))
        return std::nullopt;
    const QString words = caption->text().simplified();
    return authoring::NewTable{.rows = rows->value(),
                               .columns = columns->value(),
                               .hasHeader = hasHeaders && header->isChecked(),
                               .hasCaption = !words.isEmpty(),
                               .caption = words.toStdString()};
}

std::optional<double> askForWidth(double now, QWidget* parent) {
    constexpr double millimetre = 72 / 25.4, least = 4, most = 1000, usual = 30;
    QDialog dialog(parent);
    dialog.setObjectName("widthDialog");
    dialog.setWindowTitle(QDialog::tr("Column Width"));
    auto* form = new QFormLayout(&dialog);
    auto* automatic = new QCheckBox(QDialog::tr("&Automatic, by the content"));
    automatic->setObjectName("automatic");
    automatic->setChecked(now <= 0);
    auto* width =
        numberBox<QDoubleSpinBox>("width", least, most, now > 0 ? now / millimetre : usual);
    width->setDecimals(1);
    width->setSuffix(QDialog::tr(" mm"));
    width->setEnabled(now > 0);
    QObject::connect(automatic, &QCheckBox::toggled, width, &QWidget::setDisabled);
    form->addRow(automatic);
    form->addRow(QDialog::tr("&Width:"), width);
    if (!isAccepted(dialog, *form))
        return std::nullopt;
    return automatic->isChecked() ? 0 : width->value() * millimetre;
}

} // namespace menus
