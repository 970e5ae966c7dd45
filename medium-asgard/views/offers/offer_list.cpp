#include "offers/offer_list.h"

#include "offers/edit_preview.h"
#include "plain/plain.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace views {

void showOffers(QVBoxLayout& column, const std::string& text,
                const std::vector<editing::Offer>& offers,
                const std::function<void(const text::Edits& edits)>& take) {
    while (QLayoutItem* item = column.takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const editing::Offer& offer : offers) {
        auto* button = new QPushButton(plain::caption(QString::fromStdString(offer.label)));
        QObject::connect(button, &QPushButton::clicked, button,
                         [take, edits = offer.edits] { take(edits); });
        column.addWidget(button);
        auto* shown = plain::markupLabel();
        shown->setText(previewOf(text, offer.edits));
        shown->setWordWrap(true);
        column.addWidget(shown);
    }
}

} // namespace views
