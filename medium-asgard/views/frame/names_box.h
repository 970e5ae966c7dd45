// A box that chooses one of a scene's elements by its name.
#pragma once

#include <QComboBox>
#include <QSignalBlocker>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <vector>

namespace views {

template <typename Element> QStringList namesOf(const std::vector<Element>& elements) {
    QStringList names;
    for (const Element& element : elements)
        names << QString::fromStdString(element.name);
    return names;
}

// The element of that name.
template <typename Element>
std::optional<std::size_t> indexNamed(const std::vector<Element>& elements, const QString& name) {
    const auto found = std::ranges::find(elements, name.toStdString(), &Element::name);
    if (found == elements.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - elements.begin());
}

// Other names, if they are others: the chosen one stays, as long as it is there and `wanted` is
// not.
inline void fill(QComboBox& box, const QStringList& names, const QString& wanted = {}) {
    QStringList shown;
    for (int i = 0; i < box.count(); ++i)
        shown << box.itemText(i);
    if (names == shown)
        return;
    const QString chosen = names.contains(wanted) ? wanted : box.currentText();
    const QSignalBlocker quiet(&box);
    box.clear();
    box.addItems(names);
    box.setCurrentIndex(std::max(0, static_cast<int>(names.indexOf(chosen))));
}

} // namespace views
