// How many words, characters and pages a document has, and what of it is selected.
#pragma once

#include "view/document_view.h"

#include <QDialog>

namespace panes {

// As it is now.
class TextCountDialog : public QDialog {
    Q_OBJECT

public:
    TextCountDialog(view::DocumentView& view, QWidget* parent);
};

} // namespace panes
