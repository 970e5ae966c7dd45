#include "menus/formula_dialog.h"

#include "formulas/empty_parts.h"
#include "formulas/plain_words.h"
#include "menus/formula_preview.h"
#include "plain/plain.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QToolButton>
#include <algorithm>
#include <array>

namespace menus {

namespace {

// A sign on a button, and what it writes: in front of what is selected, and behind it.
struct Sign {
    const char* shown;
    const char* before;
    const char* after;
};
constexpr std::array signs{
    Sign{"a/b", "\\frac{", "}{}"},
    Sign{"√", "\\sqrt{", "}"},
    Sign{"xⁿ", "^{", "}"},
    Sign{"xₙ", "_{", "}"},
    Sign{"( )", "\\left( ", " \\right)"},
    Sign{"Σ", "\\sum_{", "}^{}"},
    Sign{"∫", "\\int_{", "}^{}"},
    Sign{"ẋ", "\\dot{", "}"},
    Sign{"x⃗", "\\vec{", "}"},
    Sign{"Abc", "\\text{", "}"},
    Sign{"[ ]", "\\begin{pmatrix} ", " & \\\\ & \\end{pmatrix}"},
    Sign{"{", "\\begin{cases} ", " & \\\\ & \\end{cases}"},
    Sign{"α", "\\alpha ", ""},
    Sign{"β", "\\beta ", ""},
    Sign{"γ", "\\gamma ", ""},
    Sign{"δ", "\\delta ", ""},
    Sign{"θ", "\\theta ", ""},
    Sign{"λ", "\\lambda ", ""},
    Sign{"μ", "\\mu ", ""},
    Sign{"π", "\\pi ", ""},
    Sign{"φ", "\\varphi ", ""},
    Sign{"ω", "\\omega ", ""},
    Sign{"Δ", "\\Delta ", ""},
    Sign{"∂", "\\partial ", ""},
    Sign{"·", "\\cdot ", ""},
    Sign{"×", "\\times ", ""},
    Sign{"±", "\\pm ", ""},
    Sign{"≤", "\\le ", ""},
    Sign{"≥", "\\ge ", ""},
    Sign{"≠", "\\ne ", ""},
    Sign{"≈", "\\approx ", ""},
    Sign{"→", "\\to ", ""},
    Sign{"⇒", "\\Rightarrow ", ""},
    Sign{"∞", "\\infty ", ""},
    Sign{"∇", "\\nabla ", ""},
    Sign{"°", "^\\circ ", ""},
};
constexpr int signsInRow = 12;

} // namespace

FormulaDialog::FormulaDialog(const QString& source, Place place, QWidget* parent)
    : QDialog(parent), field_(new QPlainTextEdit(source, this)), preview_(new FormulaPreview(this)),
      fault_(plain::label({}, this)), tex_(new QPushButton(tr("Write It in Te&X"), this)),
      alone_(new QRadioButton(tr("&On its own"), this)),
      numbered_(new QRadioButton(tr("On its own, with a &number"), this)),
      places_(new QHBoxLayout) {
    setObjectName("formulaDialog");
    setWindowTitle(tr("Formula"));
    field_->setObjectName("source");
    field_->setAccessibleName(tr("Formula, as TeX writes mathematics"));
    field_->setPlaceholderText(tr("As TeX writes it: E = \\frac{1}{2} m v^2"));
    field_->setTabChangesFocus(true);
    field_->setFixedHeight(field_->fontMetrics().lineSpacing() * 3 + 12);
    field_->installEventFilter(this);
    field_->moveCursor(QTextCursor::End);
    fault_->setObjectName("fault");
    fault_->setWordWrap(true);
    fault_->setMinimumHeight(fault_->fontMetrics().lineSpacing() * 2);
    tex_->setObjectName("tex");
    tex_->setAutoDefault(false);
    QSizePolicy kept = tex_->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    tex_->setSizePolicy(kept);
    connect(tex_, &QPushButton::clicked, this, &FormulaDialog::writeTex);
    connect(preview_, &FormulaPreview::wantsToWrite, this, &FormulaDialog::goTo);
    auto* said = new QHBoxLayout;
    said->addWidget(fault_, 1);
    said->addWidget(tex_);
    auto* inLine = new QRadioButton(tr("In the &line"), this);
    inLine->setObjectName("inLine");
    alone_->setObjectName("alone");
    numbered_->setObjectName("numbered");
    (place == Place::inLine  ? inLine
     : place == Place::alone ? alone_
                             : numbered_)
        ->setChecked(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    for (QRadioButton* one : {inLine, alone_, numbered_})
        places_->addWidget(one);
    places_->addStretch();
    auto* column = new QVBoxLayout(this);
    column->addWidget(preview_, 1);
    column->addWidget(field_);
    column->addLayout(said);
    column->addWidget(makeSigns());
    column->addLayout(places_);
    column->addWidget(buttons);
    connect(field_, &QPlainTextEdit::textChanged, this, [this, buttons] {
        look();
        buttons->button(QDialogButtonBox::Ok)->setEnabled(!this->source().isEmpty());
    });
    for (QRadioButton* one : {inLine, alone_, numbered_})
        connect(one, &QRadioButton::toggled, this, &FormulaDialog::look);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(!source.isEmpty());
    look();
    field_->setFocus();
}

void FormulaDialog::standBy(const QRect& place) {
    constexpr int gap = 6;
    setWindowFlag(Qt::FramelessWindowHint);
    adjustSize();
    const QRect all = parentWidget()->screen()->availableGeometry();
    const int below = place.bottom() + gap, above = place.top() - gap - height();
    const bool isBelow = below + height() <= all.bottom() || above < all.top();
    const int lowest = std::max(all.top(), all.bottom() - height());
    const int rightmost = std::max(all.left(), all.right() - width());
    move(std::clamp(place.left(), all.left(), rightmost),
         std::clamp(isBelow ? below : above, all.top(), lowest));
}

void FormulaDialog::paintEvent(QPaintEvent* event) {
    QDialog::paintEvent(event);
    if (!windowFlags().testFlag(Qt::FramelessWindowHint))
        return;
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void FormulaDialog::offerValues(std::function<QString(QWidget* parent)> ask,
                                const QString& refused) {
    auto* button = new QPushButton(tr("&Value of a Figure..."), this);
    button->setObjectName("value");
    button->setAutoDefault(false);
    button->setEnabled(refused.isEmpty());
    button->setToolTip(plain::tip(refused));
    places_->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, ask = std::move(ask)] {
        if (const QString chosen = ask(this); !chosen.isEmpty())
            put(chosen, {});
    });
}

QWidget* FormulaDialog::makeSigns() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    int at = 0;
    for (const Sign& sign : signs) {
        auto* button = new QToolButton(box);
        const QString before = QString::fromUtf8(sign.before);
        const QString after = QString::fromUtf8(sign.after);
        button->setText(plain::ours(QString::fromUtf8(sign.shown)));
        button->setToolTip(plain::tip(before + after));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus); // the keys are faster: TeX is typed
        button->setFixedSize(38, 28);
        connect(button, &QToolButton::clicked, this, [this, before, after] { put(before, after); });
        grid->addWidget(button, at / signsInRow, at % signsInRow);
        ++at;
    }
    return box;
}

// The selection comes to stand in the sign; else the caret does.
void FormulaDialog::put(const QString& before, const QString& after) {
    QTextCursor cursor = field_->textCursor();
    const QString selected = cursor.selectedText();
    cursor.insertText(before + selected + after);
    if (selected.isEmpty())
        cursor.movePosition(QTextCursor::Left, QTextCursor::MoveAnchor,
                            static_cast<int>(after.size()));
    else if (after.endsWith("{}"))
        cursor.movePosition(QTextCursor::Left);
    field_->setTextCursor(cursor);
    field_->setFocus();
}

QString FormulaDialog::source() const { return field_->toPlainText().trimmed(); }

FormulaDialog::Place FormulaDialog::place() const {
    return numbered_->isChecked() ? Place::numbered
           : alone_->isChecked()  ? Place::alone
                                  : Place::inLine;
}

int FormulaDialog::letters(std::size_t bytes) const {
    const std::string all = field_->toPlainText().toStdString();
    return static_cast<int>(QString::fromUtf8(all.data(), static_cast<qsizetype>(bytes)).size());
}

void FormulaDialog::goTo(std::size_t place) {
    QTextCursor cursor = field_->textCursor();
    cursor.setPosition(letters(place));
    field_->setTextCursor(cursor);
    field_->setFocus();
}

bool FormulaDialog::goOn(bool forward) {
    const QString all = field_->toPlainText();
    const formulas::Formula formula = formulas::read(all.toStdString());
    const auto here =
        static_cast<std::size_t>(all.left(field_->textCursor().position()).toUtf8().size());
    const std::optional<std::size_t> place =
        forward ? formulas::nextPlace(formula, here) : formulas::placeBefore(formula, here);
    if (place)
        goTo(*place);
    return place.has_value();
}

void FormulaDialog::mark(text::Range bytes, const QColor& color) {
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(field_->document());
    mark.cursor.setPosition(letters(bytes.from));
    mark.cursor.setPosition(letters(bytes.to), QTextCursor::KeepAnchor);
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(color);
    field_->setExtraSelections(field_->extraSelections() << mark);
}

// A fault comes before what was meant, perhaps, by words that TeX reads letter by letter.
void FormulaDialog::look() {
    const std::string bytes = field_->toPlainText().toStdString();
    formulas::Formula formula = formulas::read(bytes);
    const std::vector<formulas::PlainWord> words = formulas::plainWords(bytes);
    field_->setExtraSelections({});
    fault_->clear();
    tex_->setVisible(!words.empty());
    if (!formula.faults.empty() && !bytes.empty()) {
        const formulas::Fault& first = formula.faults.front();
        fault_->setText(QString::fromStdString(first.message));
        mark({first.offset, first.end}, QColor(0xc0, 0x1c, 0x28));
    } else if (!words.empty()) {
        const QString tex = QString::fromStdString(formulas::withTex(bytes, words));
        constexpr qsizetype longest = 100; // of what two lines show
        fault_->setText(
            QString::fromStdString(words.front().message) +
            (words.size() > 1 && tex.size() < longest ? tr(" All of it: %1").arg(tex) : QString()));
        tex_->setToolTip(plain::tip(tex));
    }
    for (const formulas::PlainWord& word : words)
        mark(word.range, QColor(0x26, 0x6e, 0xd6));
    preview_->show(std::move(formula),
                   place() == Place::inLine ? formulas::Style::text : formulas::Style::display);
}

void FormulaDialog::writeTex() {
    const std::string bytes = field_->toPlainText().toStdString();
    QTextCursor all(field_->document()); // one step of the field's undo
    all.select(QTextCursor::Document);
    all.insertText(QString::fromStdString(formulas::withTex(bytes, formulas::plainWords(bytes))));
    field_->setFocus();
}

bool FormulaDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched == field_ && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isReturn = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (isReturn && !(key->modifiers() & Qt::ShiftModifier)) {
            if (!source().isEmpty())
                accept();
            return true;
        }
        const bool isTab = key->key() == Qt::Key_Tab, isBack = key->key() == Qt::Key_Backtab;
        if ((isTab || isBack) && goOn(isTab))
            return true;
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace menus
