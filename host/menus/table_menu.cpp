#include "menus/table_menu.h"

#include "authoring/new_table.h"
#include "authoring/table_nodes.h"
#include "menus/table_dialog.h"
#include "strips/stock.h"
#include "view/document_view.h"

namespace menus {

using authoring::Direction, authoring::Manuscript, authoring::Selection, authoring::TablePart;

namespace {

CommandMenu::Command towards(authoring::Result (*command)(const Manuscript&, Selection, Direction),
                             Direction direction) {
    return [=](const Manuscript& in, Selection at) { return command(in, at, direction); };
}

} // namespace

TableMenu::TableMenu(view::DocumentView& view, QWidget* parent)
    : CommandMenu(tr("&Table"), view, parent) {
    setObjectName("table");
    addBeginning();
    addAsking(
        "insertTable", tr("&New Table..."), QKeySequence("Ctrl+F12"),
        [](const Manuscript& in, Selection at) { return authoring::insertTable(in, at, {}); },
        [this] { askForTable(); });
    addSeparator();
    addRowsAndColumns();
    addSeparator();
    addCells();
    connect(this, &QMenu::aboutToShow, this, &TableMenu::checkHeader);
}

void TableMenu::addRowsAndColumns() {
    const Direction before = Direction::backward, behind = Direction::forward;
    add("rowAbove", tr("Row &Above"), QKeySequence("Ctrl+Alt+Up"),
        towards(authoring::insertRow, before));
    add("rowBelow", tr("Row &Below"), QKeySequence("Ctrl+Alt+Down"),
        towards(authoring::insertRow, behind));
    add("columnLeft", tr("Column to the &Left"), QKeySequence("Ctrl+Alt+Left"),
        towards(authoring::insertColumn, before));
    add("columnRight", tr("Column to the &Right"), QKeySequence("Ctrl+Alt+Right"),
        towards(authoring::insertColumn, behind));
    addSeparator();
    add("removeRow", tr("Remove R&ow"), {}, authoring::removeRow);
    add("removeColumn", tr("Remove Colu&mn"), {}, authoring::removeColumn);
    add("removeTable", tr("Remove Tabl&e"), {}, authoring::removeTable);
    addSeparator();
    // Their keys are the view's: elsewhere they are those of other commands.
    add("rowUp", tr("Move Row &Up") + "\tAlt+Up", {}, towards(authoring::moveRow, before));
    add("rowDown", tr("Move Row &Down") + "\tAlt+Down", {}, towards(authoring::moveRow, behind));
    add("columnBack", tr("Move Column Le&ft") + "\tAlt+Left", {},
        towards(authoring::moveColumn, before));
    add("columnOn", tr("Move Column Ri&ght") + "\tAlt+Right", {},
        towards(authoring::moveColumn, behind));
}

void TableMenu::addCells() {
    add("joinCells", tr("&Join Cells"), {}, authoring::joinCells);
    add("splitCell", tr("Sp&lit Cell"), {}, authoring::splitCell);
    header_ = add("headerRow", tr("&Header Row"), {}, authoring::toggleHeader);
    header_->setCheckable(true);
    addAsking(
        "columnWidth", tr("Column &Width..."), {},
        [](const Manuscript& in, Selection at) { return authoring::setColumnWidth(in, at, 0); },
        [this] { askForWidth(); });
    addAlignment();
    addSeparator();
    auto* parts = new CommandMenu(tr("&Select"), view(), this);
    const auto select = [&](const char* name, const QString& text, TablePart part) {
        parts->add(name, text, {}, [part](const Manuscript& in, Selection at) {
            return authoring::selectInTable(in, at, part);
        });
    };
    select("selectCell", tr("&Cell"), TablePart::cell);
    select("selectRow", tr("&Row"), TablePart::row);
    select("selectColumn", tr("C&olumn"), TablePart::column);
    select("selectTable", tr("&Table"), TablePart::table);
    addMenu(parts);
}

void TableMenu::addAlignment() {
    auto* align = new CommandMenu(tr("Al&ign"), view(), this);
    align->setObjectName("alignCells");
    std::vector<std::pair<QAction*, std::string>> all;
    const auto addOne = [&](const char* name, const QString& text, const char* how) {
        QAction* action = align->add(name, text, {}, [how](const Manuscript& in, Selection at) {
            return authoring::alignCells(in, at, how);
        });
        action->setCheckable(true);
        all.emplace_back(action, how);
    };
    addOne("cellLeft", tr("&Left"), "left");
    addOne("cellCenter", tr("&Centre"), "center");
    addOne("cellRight", tr("&Right"), "right");
    addOne("cellAutomatic", tr("&Automatic: Numbers by Their Point"), "");
    connect(align, &QMenu::aboutToShow, this, [this, all] {
        const auto selection = view().writing().place();
        const auto now =
            selection ? authoring::alignmentOfCells(view().writing().manuscript(), *selection)
                      : std::nullopt;
        for (const auto& [action, how] : all)
            action->setChecked(now == how);
    });
    addMenu(align);
}

bool TableMenu::isInTable() const {
    const view::Writing& writing = view().writing();
    return writing.place() &&
           authoring::tableAround(writing.manuscript(), *writing.place()).has_value();
}

void TableMenu::checkHeader() {
    const Manuscript in = view().writing().manuscript();
    const auto selection = view().writing().place();
    const auto table = selection ? authoring::tableAround(in, *selection) : std::nullopt;
    const authoring::Grammar* grammar = in.grammars.of(in.document.className());
    header_->setChecked(table && grammar &&
                        table->isHeader(in.document.tree(), *grammar, table->selected.bottom));
}

void TableMenu::askForTable() {
    const Manuscript in = view().writing().manuscript();
    const authoring::Grammar* grammar = in.grammars.of(in.document.className());
    const bool hasHeaders =
        grammar && grammar->hasAttribute(grammar->named(schemas::Display::row), "KIND");
    const std::optional<authoring::NewTable> wanted =
        menus::askForTable(hasHeaders, parentWidget());
    if (!wanted)
        return;
    // An empty table of automatic columns would be a few blanks wide.
    double width = 0;
    if (const std::shared_ptr<const model::Model> model = view().model())
        width = model->page.width - model->page.marginLeft - model->page.marginRight;
    view().writing().perform([&](const Manuscript& to, Selection at) {
        return authoring::insertTable(to, at, *wanted, width / wanted->columns);
    });
}

void TableMenu::askForWidth() {
    const Manuscript in = view().writing().manuscript();
    const auto table = authoring::tableAround(in, *view().writing().place());
    if (!table)
        return;
    const std::vector<std::string> widths = table->widths(in.document.tree());
    const std::size_t column = table->selected.left;
    const std::string now = column < widths.size() ? widths[column] : "auto";
    const std::optional<double> wanted =
        menus::askForWidth(schemas::lengthOf(now).value_or(0), parentWidget());
    if (wanted)
        view().writing().perform([&](const Manuscript& to, Selection at) {
            return authoring::setColumnWidth(to, at, *wanted);
        });
}

} // namespace menus
