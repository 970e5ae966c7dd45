#include "frame/help_page.h"

#include "frame/icons.h"
#include "frame/manual.h"
#include "plain/plain.h"

#include <QApplication>
#include <QCursor>
#include <QDialog>
#include <QFile>
#include <QHBoxLayout>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

namespace {

constexpr const char* property = "helpTopic";

QString allPages() {
    QFile file(QStringLiteral(":/manual/help.md"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

class HelpWindow : public QDialog {
public:
    HelpWindow() : words_(new QTextBrowser), manual_(new QPushButton(QObject::tr("&Manual"))) {
        setObjectName("help");
        setWindowFlags(Qt::Tool);
        setAttribute(Qt::WA_DeleteOnClose);
        setAttribute(Qt::WA_QuitOnClose, false);
        setWindowTitle(QObject::tr("Help"));
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(10, 10, 10, 10);
        words_->setObjectName("helpWords");
        words_->setFrameShape(QFrame::NoFrame);
        column->addWidget(words_, 1);
        auto* row = new QHBoxLayout;
        row->addStretch();
        manual_->setObjectName("helpManual");
        row->addWidget(manual_);
        auto* close = new QPushButton(QObject::tr("&Close"));
        row->addWidget(close);
        column->addLayout(row);
        connect(close, &QPushButton::clicked, this, &QDialog::close);
        connect(manual_, &QPushButton::clicked, this, [this] {
            const QString chapter = chapter_;
            this->close();
            showManual(chapter);
        });
        resize(430, 330);
    }

    void show(const HelpPage& page) {
        words_->setMarkdown(plain::ours(page.words));
        chapter_ = page.chapter;
        manual_->setToolTip(plain::tip(QObject::tr("More: %1").arg(chapter_)));
        QDialog::show();
        raise();
        activateWindow();
    }

private:
    QTextBrowser* words_;
    QPushButton* manual_;
    QString chapter_;
};

// Beside the pointer, and within its screen.
void placeAtPointer(QWidget& window) {
    const QPoint at = QCursor::pos();
    const QScreen* screen = QGuiApplication::screenAt(at);
    if (!screen)
        return;
    const QRect room = screen->availableGeometry();
    constexpr int gap = 24;
    const auto within = [](int low, int value, int high) {
        return std::clamp(value, low, std::max(low, high));
    };
    window.move(within(room.left(), at.x() + gap, room.right() - window.width() - gap),
                within(room.top(), at.y() + gap, room.bottom() - window.height() - 2 * gap));
}

} // namespace

void setHelp(QWidget& widget, const QString& topic) { widget.setProperty(property, topic); }

QString helpOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget())
        if (const QString topic = widget->property(property).toString(); !topic.isEmpty())
            return topic;
    return {};
}

std::optional<HelpPage> helpPage(const QString& topic) {
    const QString all = allPages();
    const QString heading = QStringLiteral("\n## %1\n").arg(topic);
    const qsizetype from = topic.isEmpty() ? -1 : all.indexOf(heading);
    if (from < 0)
        return std::nullopt;
    const qsizetype to = all.indexOf(QStringLiteral("\n## "), from + heading.size() - 1);
    QString words = all.mid(from + 1, to < 0 ? -1 : to - from - 1).trimmed();
    const QString behind = QStringLiteral("\nManual: ");
    const qsizetype chapter = words.lastIndexOf(behind);
    if (chapter < 0)
        return HelpPage{words, {}};
    return HelpPage{words.left(chapter).trimmed(), words.mid(chapter + behind.size()).trimmed()};
}

void showHelp(const QString& topic) {
    const std::optional<HelpPage> page = helpPage(topic);
    if (!page)
        return showManual();
    static QPointer<HelpWindow> window;
    if (!window) {
        window = new HelpWindow;
        placeAtPointer(*window);
    }
    window->show(*page);
}

void showAbout(QWidget* over) {
    plain::Message box(QMessageBox::NoIcon, QObject::tr("About Asgard"), {}, QMessageBox::Close,
                       over);
    box.setObjectName("about");
    box.setIconPixmap(applicationIcon().pixmap(64, 64));
    box.setMarkup(QObject::tr("<h3>Asgard %1</h3>"
                              "<p>Computes the motion of bodies as their equations say, to a "
                              "stated accuracy, and draws it in pages and windows.</p>"
                              "<p>Free under the GNU General Public License, version 3 or later. "
                              "With Qt %2 and QScintilla.</p>")
                      .arg(QStringLiteral(ASGARD_VERSION), QString::fromLatin1(qVersion())));
    box.exec();
}

} // namespace views
