#include "start/first_page.h"

#include "frame/icons.h"
#include "plain/plain.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>
#include <QWindow>

#include <algorithm>
#include <utility>

namespace views {

namespace {

constexpr QSize card(200, 150);    // of a picture, in points, the least
constexpr QSize largest(300, 225); // where few stand in a row
constexpr int gap = 14;            // between them
constexpr int edge = 24;

// Until a picture is drawn, and where none can be.
QPixmap emptyCard(const QPalette& palette, qreal ratio) {
    QPixmap pixmap(largest * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(palette.color(QPalette::AlternateBase));
    return pixmap;
}

QLabel* heading(const QString& text) {
    QLabel* label = plain::label(text);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    font.setBold(true);
    label->setFont(font);
    return label;
}

} // namespace

FirstPage::FirstPage(QList<Sample> samples, const QStringList& recent, SamplePictures* pictures,
                     QWidget* parent)
    : QMainWindow(parent), samples_(std::move(samples)), pictures_(pictures) {
    setObjectName("firstPage");
    setWindowTitle(tr("Asgard"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(edge, edge, edge, edge);
    row->setSpacing(edge);
    row->addWidget(buildLeft(recent));
    row->addWidget(buildSamples(), 1);
    setCentralWidget(whole);
    for (const Sample& sample : samples_)
        addSample(sample);
    if (pictures) {
        connect(pictures, &SamplePictures::drawn, this, &FirstPage::showPicture);
        askForPictures();
    }
    addAction(tr("Close"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &QWidget::close);
    addAction(tr("Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), this, &FirstPage::quitWanted);
    list_->setFocus();
    list_->setCurrentRow(0);
    constexpr QSize usual(1120, 780);
    resize(usual.boundedTo(screen()->availableGeometry().size() - QSize(16, 40)));
}

// Sharp on a fine screen, too, and on the paper of the list.
void FirstPage::askForPictures() {
    const std::pair wanted(largest * devicePixelRatioF(), palette().color(QPalette::Base));
    if (pictures_ && std::exchange(asked_, wanted) != wanted)
        pictures_->ask(samples_, wanted.first, wanted.second);
}

QWidget* FirstPage::buildLeft(const QStringList& recent) {
    auto* left = new QWidget;
    left->setFixedWidth(240);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    auto* name = new QHBoxLayout;
    QLabel* mark = plain::label();
    mark->setPixmap(applicationIcon().pixmap(QSize(48, 48), devicePixelRatioF()));
    name->addWidget(mark);
    QLabel* title = heading(tr("Asgard"));
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 1.6);
    title->setFont(font);
    name->addWidget(title, 1);
    column->addLayout(name);
    QLabel* line = plain::label(tr("Motion as nature makes it, computed to a stated accuracy"));
    line->setWordWrap(true);
    line->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(line);
    column->addSpacing(12);
    const auto button = [&](const QString& label, const char* object, Icon which, auto signal) {
        auto* one = new QPushButton(plain::ours(label));
        one->setIcon(icon(which, palette()));
        one->setObjectName(object);
        one->setMinimumHeight(38);
        one->setIconSize(QSize(20, 20));
        connect(one, &QPushButton::clicked, this, signal);
        column->addWidget(one);
        return one;
    };
    button(tr("&New Scene"), "newScene", Icon::newScene, &FirstPage::newWanted)
        ->setShortcut(QKeySequence::New);
    button(tr("&Open…"), "open", Icon::open, &FirstPage::openWanted)
        ->setShortcut(QKeySequence::Open);
    button(tr("&Tour: a Pendulum in Five Steps"), "tour", Icon::play, &FirstPage::tourWanted);
    column->addSpacing(12);
    recent_ = new QListWidget;
    recent_->setObjectName("recent");
    recent_->setAccessibleName(tr("Files that were opened last"));
    recent_->setFrameShape(QFrame::NoFrame);
    recent_->setTextElideMode(Qt::ElideMiddle);
    for (const QString& path : recent) {
        auto* item = new QListWidgetItem(QFileInfo(path).fileName(), recent_);
        item->setData(Qt::UserRole, path);
        item->setToolTip(plain::tip(QDir::toNativeSeparators(path)));
    }
    const auto wanted = [this](const QListWidgetItem* item) {
        Q_EMIT fileWanted(item->data(Qt::UserRole).toString());
    };
    connect(recent_, &QListWidget::itemActivated, this, wanted);
    column->addWidget(heading(tr("Opened last")));
    if (recent.isEmpty()) {
        recent_->hide();
        QLabel* none = plain::label(tr("No file yet"));
        none->setForegroundRole(QPalette::PlaceholderText);
        column->addWidget(none);
        column->addStretch();
    } else {
        column->addWidget(recent_, 1);
    }
    return left;
}

QWidget* FirstPage::buildSamples() {
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    auto* top = new QHBoxLayout;
    top->addWidget(heading(tr("Samples")));
    top->addStretch();
    auto* groups = new QComboBox;
    groups->setObjectName("groups");
    groups->setAccessibleName(tr("Group of samples"));
    groups->addItem(tr("All"));
    for (const Sample& sample : samples_)
        if (!sample.group.isEmpty() && groups->findText(sample.group) < 0)
            groups->addItem(sample.group);
    connect(groups, &QComboBox::currentIndexChanged, this, [this, groups](int index) {
        showGroup(index > 0 ? groups->itemText(index) : QString());
    });
    top->addWidget(groups);
    column->addLayout(top);
    list_ = new QListWidget;
    list_->setObjectName("samples");
    list_->setAccessibleName(tr("Samples"));
    list_->setViewMode(QListView::IconMode);
    list_->setMovement(QListView::Static);
    list_->setResizeMode(QListView::Adjust);
    list_->setUniformItemSizes(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // cards do not come and go with it
    list_->viewport()->installEventFilter(this);
    fitCards();
    column->addWidget(list_, 1);
    if (samples_.isEmpty()) {
        list_->hide();
        groups->hide();
        QLabel* none = plain::label(
            tr("No samples are installed: they belong beside the program, with its manifest "
               "asgard.medium.json. A new scene and the tour need none."));
        none->setObjectName("noSamples");
        none->setWordWrap(true);
        none->setForegroundRole(QPalette::PlaceholderText);
        column->addWidget(none);
        column->addStretch();
    }
    about_ = plain::label();
    about_->setObjectName("about");
    column->addWidget(about_);
    connect(list_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        if (const Sample* sample = sampleOf(*item))
            Q_EMIT sampleWanted(*sample);
    });
    connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        const Sample* sample = item ? sampleOf(*item) : nullptr;
        about_->setText(sample ? tr("%1 – double click or Return opens it").arg(sample->about)
                               : QString());
    });
    return right;
}

void FirstPage::addSample(const Sample& sample) {
    auto* item =
        new QListWidgetItem(emptyCard(palette(), devicePixelRatioF()), sample.title, list_);
    item->setData(Qt::UserRole, sample.path);
    item->setToolTip(plain::tip(sample.about));
    item->setData(Qt::AccessibleTextRole, tr("%1: %2").arg(sample.title, sample.about));
}

const Sample* FirstPage::sampleOf(const QListWidgetItem& item) const {
    for (const Sample& sample : samples_)
        if (sample.path == item.data(Qt::UserRole).toString())
            return &sample;
    return nullptr;
}

void FirstPage::showPicture(const Sample& sample, const QImage& image) {
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->data(Qt::UserRole).toString() == sample.path)
            list_->item(i)->setIcon(QPixmap::fromImage(image));
}

void FirstPage::showGroup(const QString& group) {
    for (int i = 0; i < list_->count(); ++i) {
        const Sample* sample = sampleOf(*list_->item(i));
        list_->setRowHidden(i, sample && !group.isEmpty() && sample->group != group);
    }
}

// As many in a row as fit, as large as they fill it.
void FirstPage::fitCards() {
    const int width = list_->viewport()->width();
    const int columns = std::max(1, (width - 1) / (card.width() + gap));
    const int cell = std::max(card.width() + gap, (width - 1) / columns);
    const QSize icon = card.scaled(QSize(cell - gap, largest.height()), Qt::KeepAspectRatio);
    list_->setIconSize(icon);
    list_->setGridSize(QSize(cell, icon.height() + list_->fontMetrics().height() + 2 * gap));
}

bool FirstPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && watched == list_->viewport())
        fitCards();
    return QMainWindow::eventFilter(watched, event);
}

void FirstPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QMainWindow::keyPressEvent(event);
}

void FirstPage::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || !list_)
        return;
    colourCards();
    askForPictures();
}

void FirstPage::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    connect(windowHandle(), &QWindow::screenChanged, this, &FirstPage::askForPictures,
            Qt::UniqueConnection);
    askForPictures();
}

void FirstPage::colourCards() {
    const std::pair<const char*, Icon> buttons[] = {
        {"newScene", Icon::newScene}, {"open", Icon::open}, {"tour", Icon::play}};
    for (const auto& [name, which] : buttons)
        findChild<QPushButton*>(name)->setIcon(icon(which, palette()));
}

} // namespace views
