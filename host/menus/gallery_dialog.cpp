#include "menus/gallery_dialog.h"

#include "plain/plain.h"
#include "session/samples.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QPixmapCache>
#include <QPushButton>
#include <QScreen>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

namespace menus {

namespace {

constexpr int pictureWidth = 208, margin = 10, titleGap = 8;
constexpr int aboutRole = Qt::UserRole, faultRole = Qt::UserRole + 1;
constexpr int aboutLines = 2;

// The places of things in a tile, and their looks.
class Tile : public QStyledItemDelegate {
public:
    Tile(double ratio, QObject* parent)
        : QStyledItemDelegate(parent), pictureHeight_(static_cast<int>(pictureWidth / ratio)) {}

    [[nodiscard]] QSize picture() const { return {pictureWidth, pictureHeight_}; }

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex&) const override {
        const int lines = (1 + aboutLines) * option.fontMetrics.lineSpacing();
        return {pictureWidth + 2 * margin, pictureHeight_ + titleGap + lines + 2 * margin};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const QRect tile = option.rect.adjusted(2, 2, -2, -2);
        if (option.state & QStyle::State_Selected) {
            QColor fill = option.palette.color(QPalette::Highlight);
            painter->setPen(QPen(fill, 2));
            constexpr double faint = 0.15;
            fill.setAlphaF(faint);
            painter->setBrush(fill);
            painter->drawRoundedRect(tile, 6, 6);
        }
        const QRect at(option.rect.topLeft() + QPoint(margin, margin), picture());
        paintPicture(*painter, at, option, index);
        QRect words = option.rect.adjusted(margin, margin + at.height() + titleGap, -margin, 0);
        painter->setPen(option.palette.color(QPalette::Text));
        QFont bold = option.font;
        bold.setBold(true);
        painter->setFont(bold);
        const QString title = index.data().toString();
        painter->drawText(words, Qt::TextSingleLine,
                          QFontMetrics(bold).elidedText(title, Qt::ElideRight, words.width()));
        words.setTop(words.top() + option.fontMetrics.lineSpacing());
        words.setHeight(aboutLines * option.fontMetrics.lineSpacing());
        painter->setFont(option.font);
        painter->drawText(words, Qt::TextWordWrap, index.data(aboutRole).toString());
        painter->restore();
    }

private:
    static void paintPicture(QPainter& painter, const QRect& at, const QStyleOptionViewItem& option,
                             const QModelIndex& index) {
        QPainterPath frame;
        frame.addRoundedRect(at, 4, 4);
        painter.setClipPath(frame);
        const auto picture = index.data(Qt::DecorationRole).value<QPixmap>();
        if (picture.isNull()) {
            painter.fillRect(at, option.palette.color(QPalette::AlternateBase));
            painter.setPen(option.palette.color(QPalette::Text));
            painter.drawText(at.adjusted(margin, margin, -margin, -margin),
                             Qt::AlignCenter | Qt::TextWordWrap, index.data(faultRole).toString());
        } else {
            painter.drawPixmap(at, picture);
        }
        painter.setClipping(false);
        QColor line = option.palette.color(QPalette::Text);
        constexpr double faint = 0.25;
        line.setAlphaF(faint);
        painter.setPen(line);
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(frame);
    }

    int pictureHeight_;
};

// A file that has changed has another picture.
QString keyOf(const media::Manifest& manifest, int sample, QSize pixels) {
    const QFileInfo file(fileOf(manifest, manifest.samples[sample]));
    return QStringLiteral("sample %1 %2 %3 %4x%5")
        .arg(manifest.documentClass, file.absoluteFilePath())
        .arg(file.lastModified().toMSecsSinceEpoch())
        .arg(pixels.width())
        .arg(pixels.height());
}

} // namespace

GalleryDialog::GalleryDialog(media::LiveMedia& media, const media::Manifest& manifest,
                             QWidget* parent)
    : QDialog(parent), list_(new QListWidget(this)), groups_(new QListWidget(this)) {
    setObjectName("gallery");
    setWindowTitle(plain::title(tr("Insert %1").arg(manifest.title)));
    list_->setObjectName("samples");
    list_->setAccessibleName(tr("Samples"));
    list_->setViewMode(QListView::IconMode);
    list_->setMovement(QListView::Static);
    list_->setResizeMode(QListView::Adjust);
    list_->setUniformItemSizes(true);
    list_->setSpacing(2);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    auto* tile = new Tile(manifest.size.width() / manifest.size.height(), this);
    list_->setItemDelegate(tile);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    QPushButton* insert = buttons->button(QDialogButtonBox::Ok);
    insert->setText(tr("&Insert"));
    insert->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->addWidget(groups_);
    row->addWidget(list_, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(list_, &QListWidget::itemSelectionChanged, this,
            [this, insert] { insert->setEnabled(chosen() >= 0); });
    fill(manifest);
    fillGroups(manifest);
    list_->setCurrentRow(0);
    list_->setFocus();
    QStyleOptionViewItem option;
    option.fontMetrics = list_->fontMetrics();
    const QSize one = tile->sizeHint(option, {}) + QSize(5, 5);
    constexpr int columns = 4, rows = 2, edge = 40;
    const int beside = groups_->isHidden() ? 0 : groups_->width() + column->spacing();
    const QSize wanted(columns * one.width() + edge + beside, rows * one.height() + 2 * edge);
    const QSize frame(edge / 2, 2 * edge); // of the window
    resize(wanted.boundedTo(screen()->availableSize() - frame));
    askForPictures(media, manifest);
}

GalleryDialog::~GalleryDialog() = default;

int GalleryDialog::chosen() const {
    const QList<QListWidgetItem*> selected = list_->selectedItems();
    return selected.isEmpty() ? -1 : list_->row(selected.first());
}

void GalleryDialog::fill(const media::Manifest& manifest) {
    for (const media::Sample& sample : manifest.samples) {
        auto* item = new QListWidgetItem(sample.title, list_);
        item->setData(aboutRole, sample.about);
        item->setData(Qt::AccessibleTextRole, sample.about.isEmpty()
                                                  ? sample.title
                                                  : tr("%1: %2").arg(sample.title, sample.about));
    }
}

void GalleryDialog::fillGroups(const media::Manifest& manifest) {
    groups_->setObjectName("groups");
    groups_->setAccessibleName(tr("Groups"));
    QStringList names;
    for (const media::Sample& sample : manifest.samples)
        if (!sample.group.isEmpty() && !names.contains(sample.group))
            names << sample.group;
    groups_->addItem(tr("All"));
    groups_->addItems(names);
    groups_->setCurrentRow(0);
    groups_->setFixedWidth(groups_->sizeHintForColumn(0) + 4 * margin);
    groups_->setVisible(!names.isEmpty());
    connect(groups_, &QListWidget::currentRowChanged, this,
            [this, manifest] { showGroup(manifest); });
}

// A chosen sample stays chosen in a group that has it.
void GalleryDialog::showGroup(const media::Manifest& manifest) {
    const QString group = groups_->currentRow() > 0 ? groups_->currentItem()->text() : QString();
    const auto belongs = [&](int i) {
        return group.isEmpty() || manifest.samples[i].group == group;
    };
    const int count = static_cast<int>(manifest.samples.size());
    for (int i = 0; i < count; ++i)
        list_->setRowHidden(i, !belongs(i));
    if (chosen() >= 0 && belongs(chosen()))
        return;
    for (int i = 0; i < count; ++i)
        if (belongs(i))
            return list_->setCurrentRow(i);
}

void GalleryDialog::askForPictures(media::LiveMedia& media, const media::Manifest& manifest) {
    const auto* tile = static_cast<const Tile*>(list_->itemDelegate());
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(tile->picture()) * ratio).toSize();
    pictures_ = new session::SamplePictures(media, manifest, pixels,
                                            pixels.width() / manifest.size.width(), this);
    connect(pictures_, &session::SamplePictures::drawn, this,
            [this, manifest, pixels, ratio](int sample, const QImage& image) {
                QPixmap picture = QPixmap::fromImage(image);
                picture.setDevicePixelRatio(ratio);
                QPixmapCache::insert(keyOf(manifest, sample, pixels), picture);
                show(sample, picture);
            });
    connect(
        pictures_, &session::SamplePictures::failed, this,
        [this](int sample, const QString& why) { list_->item(sample)->setData(faultRole, why); });
    for (int i = 0; i < manifest.samples.size(); ++i) {
        QPixmap known;
        if (QPixmapCache::find(keyOf(manifest, i, pixels), &known))
            show(i, known);
        else
            pictures_->add(i);
    }
}

void GalleryDialog::show(int sample, const QPixmap& picture) {
    list_->item(sample)->setData(Qt::DecorationRole, picture);
}

} // namespace menus
