#include "frame/spoken.h"

#include <QAccessibleWidget>
#include <QLabel>

namespace views {

namespace {

// A label with a name: Qt tells the name in place of the words that it shows.
class SpokenLabel : public QAccessibleWidget {
public:
    explicit SpokenLabel(QLabel* label) : QAccessibleWidget(label, QAccessible::StaticText) {}

    [[nodiscard]] QString text(QAccessible::Text which) const override {
        const auto* label = static_cast<const QLabel*>(widget());
        if (which == QAccessible::Value)
            return label->text();
        if (which == QAccessible::Name && !label->text().isEmpty())
            return QLabel::tr("%1: %2").arg(label->accessibleName(), label->text());
        return QAccessibleWidget::text(which);
    }
};

QAccessibleInterface* spoken(const QString& className, QObject* object) {
    if (className == QLatin1String("QLabel"))
        if (auto* label = qobject_cast<QLabel*>(object);
            label && !label->accessibleName().isEmpty())
            return new SpokenLabel(label);
    return nullptr;
}

} // namespace

void speakValues() {
    static const bool once = [] {
        QAccessible::installFactory(spoken);
        return true;
    }();
    static_cast<void>(once);
}

} // namespace views
