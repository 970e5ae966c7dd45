#include "shapes/shapes_menu.h"

#include "frame/windows.h"
#include "plain/plain.h"
#include "point_edits/shape_library.h"
#include "shapes/shape_names.h"

#include <QMenu>

namespace views {

namespace {

void addFromLibrary(QMenu* menu, SceneDocument& document, const editing::LibraryShape& shape) {
    const QString what = QString::fromStdString(shape.name);
    const QString name = unusedShapeName(document, what.toLower());
    const QString fault =
        makeShape(document, name, shape.parts, QObject::tr("New Shape %1").arg(name));
    if (!fault.isEmpty())
        plain::Message::tell(QMessageBox::Warning, menu, QObject::tr("New Shape"), fault);
}

void fillShapes(QMenu* menu, SceneDocument& document, const Windows& windows) {
    menu->clear();
    for (const scene::ShapeSet& set : document.shown().scene->shapeSets) {
        const QString name = QString::fromStdString(set.name);
        menu->addAction(plain::caption(name), menu,
                        [&windows, name] { windows.openShapeEditor(name); });
    }
    menu->setEnabled(!menu->isEmpty());
}

} // namespace

void buildShapesMenu(QMenu* menu, SceneDocument& document, const Windows& windows) {
    menu->addAction(QObject::tr("&New Shape…"), menu, [&windows] { windows.newShape(); });
    QMenu* library = menu->addMenu(QObject::tr("New from the &Library"));
    for (const editing::LibraryShape& shape : editing::shapeLibrary())
        library->addAction(plain::caption(QString::fromStdString(shape.name)), menu,
                           [menu, &document, &shape] { addFromLibrary(menu, document, shape); });
    menu->addAction(QObject::tr("&Import…"), menu, [&windows] { windows.importShape(); });
    menu->addSeparator();
    // Opens with the shape of what is selected.
    menu->addAction(QObject::tr("Shape &Editor"), QKeySequence(Qt::CTRL | Qt::Key_E), menu,
                    [&windows] { windows.openShapeEditor({}); });
    QMenu* edit = menu->addMenu(QObject::tr("E&dit"));
    QObject::connect(menu, &QMenu::aboutToShow, edit,
                     [edit, &document, &windows] { fillShapes(edit, document, windows); });
    fillShapes(edit, document, windows);
}

} // namespace views
