#include "menus/link_dialog.h"

#include "plain/plain.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace menus {

namespace {

// As one types it in a browser: "www.example.org" has no scheme.
QString completed(const QString& address) {
    const bool looksLikeWeb = address.startsWith("www.", Qt::CaseInsensitive);
    return looksLikeWeb ? "https://" + address : address;
}

} // namespace

std::optional<QString> askForLink(const QString& address, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setObjectName("linkDialog");
    dialog.setWindowTitle(QDialog::tr("Link"));
    auto* column = new QVBoxLayout(&dialog);
    auto* label = plain::label(QDialog::tr("Address of a page, or # and the ID of an element:"));
    auto* field = new QLineEdit(address, &dialog);
    field->setObjectName("address");
    field->setPlaceholderText("https://example.org/");
    field->setMinimumWidth(360);
    field->selectAll();
    label->setBuddy(field);
    column->addWidget(label);
    column->addWidget(field);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    column->addWidget(buttons);
    QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
    const auto update = [field, ok] { ok->setEnabled(!field->text().trimmed().isEmpty()); };
    QObject::connect(field, &QLineEdit::textChanged, &dialog, update);
    update();
    bool isRemoved = false;
    if (!address.isEmpty()) {
        QPushButton* remove =
            buttons->addButton(QDialog::tr("&Remove Link"), QDialogButtonBox::DestructiveRole);
        remove->setObjectName("removeLink");
        QObject::connect(remove, &QPushButton::clicked, &dialog, [&] {
            isRemoved = true;
            dialog.accept();
        });
    }
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return isRemoved ? QString() : completed(field->text().trimmed());
}

} // namespace menus
