#include "panes/text_count_dialog.h"

#include "excerpts/selected.h"
#include "plain/plain.h"
#include "reading/text_count.h"
#include "view/text_hand.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLocale>

namespace panes {

namespace {

// The pages from that of one place to that of the other.
std::size_t pagesOf(const view::DocumentView& view, text::Range interval) {
    const places::Carets carets(view.pages(), view.document().document().tree());
    const auto first = carets.of(interval.from, 0), last = carets.of(interval.to, 0);
    return first && last ? std::max(first->page, last->page) - first->page + 1 : 0;
}

class Table {
public:
    explicit Table(QGridLayout& grid) : grid_(grid) {}

    // One column of numbers below a title; `name` with a number behind it is that of each.
    void addColumn(const QString& title, const QString& name,
                   const std::vector<std::size_t>& numbers) {
        ++column_;
        put(0, title)->setObjectName(name);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            put(static_cast<int>(i) + 1, QLocale().toString(static_cast<qulonglong>(numbers[i])))
                ->setObjectName(name + QString::number(i));
    }
    void addNames(const QStringList& names) {
        for (int i = 0; i < names.size(); ++i)
            grid_.addWidget(plain::label(names[i]), i + 1, 0);
    }

private:
    QLabel* put(int row, const QString& text) {
        QLabel* label = plain::label(text);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        grid_.addWidget(label, row, column_, Qt::AlignRight);
        return label;
    }

    QGridLayout& grid_;
    int column_ = 0;
};

} // namespace

TextCountDialog::TextCountDialog(view::DocumentView& view, QWidget* parent) : QDialog(parent) {
    setObjectName("textCount");
    setWindowTitle(tr("Word Count"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(24);
    Table table(*grid);
    table.addNames({tr("Words"), tr("Characters"), tr("Characters without blanks"), tr("Pages")});
    const auto numbers = [](const reading::TextCount& count, std::size_t pages) {
        return std::vector<std::size_t>{count.words, count.characters, count.notBlank, pages};
    };
    view.settle();
    if (const std::shared_ptr<const model::Model> model = view.model()) {
        const text::Range selected = view.text().cursor().interval();
        if (!selected.empty()) {
            const sgml::Tree& tree = view.document().document().tree();
            const reading::TextCount count =
                reading::countText(model::excerpt(tree, *model, selected));
            table.addColumn(tr("Selection"), "selected", numbers(count, pagesOf(view, selected)));
        }
        table.addColumn(tr("Document"), "all",
                        numbers(reading::countText(*model), view.pages().pages.size()));
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addLayout(grid);
    column->addWidget(buttons);
    setAttribute(Qt::WA_DeleteOnClose);
}

} // namespace panes
