#include "view/copying.h"

#include "model/copy_export.h"
#include "model/fragment.h"
#include "model/selected.h"

namespace view {

std::unique_ptr<QMimeData> copied(const document::Document& document, const model::Model& model,
                                  text::Range interval) {
    const model::Model part = model::excerpt(document.tree(), model, interval);
    auto result = std::make_unique<QMimeData>();
    result->setText(QString::fromStdString(model::copiedText(document, part)));
    result->setHtml(QString::fromStdString(model::copiedHtml(document, part)));
    const std::string own = model::fragment(document.tree(), interval);
    if (!own.empty())
        result->setData(fragmentFormat, QByteArray::fromStdString(own));
    return result;
}

} // namespace view
