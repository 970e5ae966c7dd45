// A sentence in the corner of a picture. It fades once there was time to read it, the longer the
// longer it is, or something else is said.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <chrono>

namespace views {

class Said : public QObject {
    Q_OBJECT
public:
    Said();

    void say(const QString& sentence, bool isFault);
    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] bool isFault() const { return isFault_; }
    [[nodiscard]] double opacity() const; // 0 to 1
    [[nodiscard]] static std::chrono::milliseconds readingTime(const QString& sentence);
    static void setPace(double factor); // of reading, for tests: 1 as readers do, 0 none at all

Q_SIGNALS:
    void changed();

private:
    void fade();

    QString text_;
    bool isFault_ = false;
    QTimer timer_;
    int left_ = 0; // steps of the fading
};

} // namespace views
