// Colours of text that can be read: a contrast of 4.5 to 1 to what is behind it, as the Web Content
// Accessibility Guidelines measure it. Disabled text may have less.
#pragma once

#include <QColor>
#include <QObject>

namespace views {

inline constexpr double readableContrast = 4.5;

[[nodiscard]] double contrast(const QColor& one, const QColor& other); // 1 to 21; both opaque
// `ink`, made darker or lighter as far as it must be to be read on `paper`.
[[nodiscard]] QColor readable(const QColor& ink, const QColor& paper);

// While this lives the application's palette has such colours only, whatever the theme says and
// whenever it says something else. Quiet words (QPalette::PlaceholderText) can be read, too.
class ReadablePalette : public QObject {
    Q_OBJECT
public:
    explicit ReadablePalette(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool adapting_ = false;
    void adapt();
};

} // namespace views
