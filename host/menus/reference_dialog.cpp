#include "menus/reference_dialog.h"

#include "plain/plain.h"

#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <map>

namespace menus {

namespace {

QString wordsOf(const model::Block& block) {
    constexpr qsizetype longest = 90;
    QString words = QString::fromStdString(block.marker) + ' ';
    for (const model::Run& run : block.runs) {
        words += QString::fromStdString(run.text);
        if (words.size() > longest)
            break;
    }
    words = words.simplified();
    return words.size() > longest ? words.left(longest) + QStringLiteral("...") : words;
}

// Its caption says what a figure or table is, its heading what a section is; the first words of
// anything else.
const model::Block* telling(const model::Model& model, const model::Container& container) {
    const bool isSection = container.role == schemas::ContainerRole::section;
    for (const model::Container& inner : model.containers)
        if (!isSection && inner.role == schemas::ContainerRole::caption &&
            inner.first >= container.first && inner.last <= container.last)
            return model.blocks[inner.first].get();
    for (std::size_t at = container.first; at <= container.last; ++at)
        if (!wordsOf(*model.blocks[at]).isEmpty())
            return model.blocks[at].get();
    return nullptr;
}

} // namespace

std::vector<Target> described(const std::vector<sgml::NodeId>& elements,
                              const model::Model& model) {
    std::map<sgml::NodeId, const model::Block*> blocks;
    for (const auto& block : model.blocks)
        blocks.emplace(block->element, block.get());
    for (const model::Container& container : model.containers)
        if (const model::Block* block = telling(model, container))
            blocks[container.element] = block;
    std::vector<Target> result;
    for (const sgml::NodeId element : elements)
        if (const auto found = blocks.find(element); found != blocks.end())
            if (const QString words = wordsOf(*found->second); !words.isEmpty())
                result.push_back({.element = element,
                                  .words = words,
                                  .isNumbered = !found->second->marker.empty()});
    return result;
}

ReferenceDialog::ReferenceDialog(std::vector<Target> targets, std::optional<bool> isByNumber,
                                 QWidget* parent)
    : QDialog(parent), targets_(std::move(targets)), field_(new QLineEdit(this)),
      list_(new QListWidget(this)), byKind_(new QRadioButton(this)),
      byNumber_(new QRadioButton(tr("The number &alone"), this)),
      isChosen_(isByNumber.has_value()) {
    setObjectName("referenceDialog");
    setWindowTitle(tr("Cross-Reference"));
    field_->setObjectName("words");
    field_->setPlaceholderText(tr("Words of a caption or heading"));
    field_->setClearButtonEnabled(true);
    field_->installEventFilter(this);
    list_->setObjectName("targets");
    list_->setAccessibleName(tr("What the reference leads to"));
    list_->setMinimumSize(440, 300);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // long captions end in "..."
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(!isByNumber ? tr("&Insert") : tr("&Change"));
    auto* column = new QVBoxLayout(this);
    QLabel* label = plain::label(tr("Refer to:"), this);
    label->setBuddy(field_);
    column->addWidget(label);
    column->addWidget(field_);
    column->addWidget(list_, 1);
    column->addWidget(byKind_);
    column->addWidget(byNumber_);
    column->addWidget(buttons);
    byKind_->setObjectName("byKind");
    byNumber_->setObjectName("byNumber");
    (isByNumber.value_or(false) ? byNumber_ : byKind_)->setChecked(true);
    for (QRadioButton* button : {byKind_, byNumber_})
        connect(button, &QRadioButton::clicked, this, [this] { isChosen_ = true; });
    connect(list_, &QListWidget::currentRowChanged, this, &ReferenceDialog::offerKinds);
    connect(field_, &QLineEdit::textChanged, this, &ReferenceDialog::filter);
    connect(list_, &QListWidget::itemDoubleClicked, this, &QDialog::accept);
    connect(list_, &QListWidget::currentRowChanged, this,
            [buttons](int row) { buttons->button(QDialogButtonBox::Ok)->setEnabled(row >= 0); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    filter({});
    field_->setFocus();
}

void ReferenceDialog::filter(const QString& words) {
    list_->clear();
    for (std::size_t at = 0; at < targets_.size(); ++at) {
        if (!targets_[at].words.contains(words.simplified(), Qt::CaseInsensitive))
            continue;
        auto* item = new QListWidgetItem(targets_[at].words, list_);
        item->setData(Qt::UserRole, static_cast<int>(at));
    }
    list_->setCurrentRow(list_->count() > 0 ? 0 : -1);
}

// Until somebody chooses, as it fits what stands before the reference.
void ReferenceDialog::offerKinds() {
    const Target* of = target();
    const bool isOffered = of && !of->kind.isEmpty();
    byKind_->setText(isOffered ? tr("%1 and &number").arg(plain::caption(of->kind))
                               : tr("Its &name"));
    byNumber_->setEnabled(isOffered);
    if (!isChosen_ || !isOffered)
        (isOffered && of->isNumberFitting ? byNumber_ : byKind_)->setChecked(true);
}

const Target* ReferenceDialog::target() const {
    const QListWidgetItem* item = list_->currentItem();
    return item ? &targets_[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())] : nullptr;
}

sgml::NodeId ReferenceDialog::chosen() const {
    const Target* of = target();
    return of ? of->element : sgml::noNode;
}

bool ReferenceDialog::isByNumber() const { return byNumber_->isChecked(); }

// The arrows choose while one types.
bool ReferenceDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched == field_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step != 0) {
            list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace menus
