#include "properties/properties_pane.h"

#include "commands/asked_value.h"
#include "editing/element_values.h"
#include "editing/number_text.h"
#include "element_edits/attitude.h"
#include "element_edits/fixing.h"
#include "element_edits/options.h"
#include "element_edits/units.h"
#include "frame/names_box.h"
#include "plain/plain.h"
#include "script/numbers.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace views {

using editing::Element;
using editing::Kind;
using editing::OptionHint;
using editing::Wants;

namespace {

QString toText(std::string_view words) { return QString::fromUtf8(words.data(), words.size()); }

// "1" of "a positive number (1)".
QString defaultIn(std::string_view words) {
    const std::size_t from = words.rfind('(');
    return from == std::string_view::npos || !words.ends_with(')') || words.size() - from > 10
               ? QString()
               : toText(words.substr(from + 1, words.size() - from - 2));
}

std::string shownNumber(double value, double resolution = 1e-9) {
    return editing::numberText(value, resolution * std::max(1.0, std::abs(value)));
}

constexpr int columnsApart = 8;

// Of rows of any kind of element, as a rule or at least: captions break between their words.
int widthOfRows(const QWidget& form, bool atLeast) {
    const std::unique_ptr<QLabel> label(plain::label());
    label->setFont(form.font());
    label->setWordWrap(true);
    const int three = PropertyRow::widthOfFields(form, atLeast);
    int widest = 0;
    for (const editing::CommandHint& command : editing::commandHints()) {
        int caption = 0;
        for (const OptionHint& option : command.options) {
            label->setText(plain::ours(QString::fromStdString(editing::captionOf(option))));
            caption = std::max(caption, label->minimumSizeHint().width());
        }
        const bool hasVector = std::ranges::any_of(
            command.options, [](const OptionHint& one) { return one.wants == Wants::vector; });
        widest = std::max(widest, caption + columnsApart + (hasVector ? three : three / 2));
    }
    return widest;
}

// The rotation vector that stands in these parts.
std::optional<geometry::Vector> vectorOf(const PropertyParts& parts) {
    geometry::Vector vector = geometry::Vector::Zero();
    if (parts.size() != 3)
        return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!parts[i])
            return std::nullopt;
        const auto number =
            parts[i]->empty() ? std::optional(0.0) : script::decimalNumber(*parts[i]);
        if (!number)
            return std::nullopt;
        vector[static_cast<Eigen::Index>(i)] = *number;
    }
    return vector;
}

} // namespace

PropertiesPane::PropertiesPane(SceneDocument& document, const PropertyActions& actions,
                               QWidget* parent)
    : QWidget(parent), document_(document), commands_(document), trial_(document),
      later_(document) {
    setObjectName(QStringLiteral("properties"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    head_ = new PropertyHead(document, commands_, later_, actions.showText);
    connect(head_, &PropertyHead::renamed, &soon_, qOverload<>(&QTimer::start));
    column->addWidget(head_);
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setObjectName(QStringLiteral("propertyScroll"));
    column->addWidget(scroll, 1);
    buildButtons(*column, actions);
    soon_.setSingleShot(true);
    soon_.setInterval(30); // a drag changes the scene often
    connect(&soon_, &QTimer::timeout, this, &PropertiesPane::refresh);
    for (const auto signal : {&SceneDocument::sceneChanged, &SceneDocument::selectionChanged,
                              &SceneDocument::diagnosticsChanged, &SceneDocument::textChanged})
        connect(&document_, signal, this, [this] {
            if (isVisible())
                soon_.start();
        });
    connect(&commands_, &ElementCommands::refused, head_, &PropertyHead::say);
    connect(&commands_, &ElementCommands::added, this, &PropertiesPane::added);
    refresh();
    reserveWidth();
}

// A field that loses the keyboard now gives what was typed to nobody.
PropertiesPane::~PropertiesPane() {
    for (PropertyRow* row : findChildren<PropertyRow*>())
        row->disconnect(this);
    head_->name().blockSignals(true);
}

void PropertiesPane::buildButtons(QVBoxLayout& column, const PropertyActions& actions) {
    buttons_ = new QWidget;
    auto* line = new QHBoxLayout(buttons_);
    line->setContentsMargins(0, 0, 0, 0);
    auto* duplicate = new QPushButton(tr("Dup&licate"));
    duplicate->setObjectName("duplicate");
    duplicate->setToolTip(tr("A copy beside it (Ctrl+D)"));
    connect(duplicate, &QPushButton::clicked, this, [this] { commands_.duplicate(); });
    shape_ = new QPushButton(tr("S&hape…"));
    shape_->setObjectName("shape");
    shape_->setToolTip(tr("Its shape, in the shape editor"));
    connect(shape_, &QPushButton::clicked, this, [this, open = actions.openShape] {
        const scene::Scene& scene = *document_.shown().scene;
        if (!isOfOneShape()) // since the button was shown
            return;
        const Element element = elements().front();
        open(QString::fromStdString(element.kind == Kind::body ? scene.bodies[element.index].shape
                                                               : editing::nameOf(scene, element)));
    });
    auto* remove = new QPushButton(tr("Dele&te"));
    connect(remove, &QPushButton::clicked, this, [this, act = actions.remove] { act(elements()); });
    for (QPushButton* button : {duplicate, shape_, remove})
        line->addWidget(button);
    column.addWidget(buttons_);
}

void PropertiesPane::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void PropertiesPane::begin() {
    refresh();
    const auto first =
        std::ranges::find_if(rows_, [](const PropertyRow* row) { return !row->fields().empty(); });
    if (first != rows_.end())
        (*first)->fields()[0]->setFocus(Qt::TabFocusReason); // with all of it selected
}

PropertyRow* PropertiesPane::row(const std::string& option) const {
    for (PropertyRow* row : rows_)
        if (row->option().name == option)
            return row;
    return nullptr;
}

// A refused value goes with its rows when something else is selected: then the head tells this.
QString PropertiesPane::refusal() const {
    QString why = head_->refusal();
    if (form_)
        for (const PropertyRow* row : form_->findChildren<PropertyRow*>())
            if (why.isEmpty())
                why = row->refusal();
    return PropertyHead::meant(head_->name().text(), why);
}

void PropertiesPane::refresh() {
    const scene::Scene& scene = *document_.shown().scene;
    const QString refused = shown_ == elements() ? QString() : refusal();
    properties_.reset();
    if (document_.sceneIsCurrent() && !elements().empty())
        properties_ =
            std::make_unique<editing::Properties>(document_.text(), document_.shown().scene);
    const auto options = editing::sharedOptions(scene, elements());
    if (options != options_ || !form_) {
        options_ = options;
        rebuild();
    }
    if (shown_ != elements()) { // what was typed was meant for others
        shown_ = elements();
        axis_.typed.reset();
        head_->forget();
        for (PropertyRow* row : form_->findChildren<PropertyRow*>())
            row->forget();
        if (!refused.isEmpty())
            head_->say(refused);
    }
    showHead();
    for (PropertyRow* row : rows_)
        showRow(*row);
    showTurn();
    showSize();
}

bool PropertiesPane::isOfOneShape() const {
    const auto& all = elements();
    return all.size() == 1 &&
           (all.front().kind == Kind::body || all.front().kind == Kind::shapeSet);
}

void PropertiesPane::showHead() {
    const auto& all = elements();
    head_->showElements(all);
    shape_->setVisible(isOfOneShape());
    buttons_->setVisible(!all.empty());
}

void PropertiesPane::rebuild() {
    rows_.clear();
    turn_ = size_ = nullptr;
    form_ = new QWidget;
    auto* column = new QVBoxLayout(form_);
    column->setContentsMargins(0, 0, 4, 0);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(columnsApart);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 2);
    grid->setColumnStretch(1, 5);
    column->addLayout(grid);
    column->addStretch();
    for (const OptionHint* option : options_) {
        auto* row =
            new PropertyRow(document_, *option, QString::fromStdString(editing::captionOf(*option)),
                            option->wants == Wants::vector ? 3 : 1, *grid, form_);
        listen(*row, &PropertiesPane::set);
        rows_.push_back(row);
        if (option->name == "-shape")
            addSize(*grid);
        if (option->name != "-init_rot")
            continue;
        turn_ = new PropertyRow(document_, *option, tr("Turned by °, about"), 4, *grid, form_);
        listen(*turn_, &PropertiesPane::setTurn);
    }
    findChild<QScrollArea*>()->setWidget(form_); // deletes the one before
}

// Whatever is selected, rows of all kinds have room: the picture beside keeps its place.
void PropertiesPane::reserveWidth() {
    auto* scroll = findChild<QScrollArea*>();
    const QMargins inside = form_->layout()->contentsMargins(),
                   around = layout()->contentsMargins();
    const int beside =
        inside.left() + inside.right() + scroll->verticalScrollBar()->sizeHint().width();
    scroll->setMinimumWidth(widthOfRows(*this, true) + beside);
    usualWidth_ = widthOfRows(*this, false) + beside + around.left() + around.right();
}

// The size is written in the shape, not in the body's command.
void PropertiesPane::addSize(QGridLayout& grid) {
    static const OptionHint size{"size", Wants::vector,
                                 "the radius, the height or the edges of its shape", ""};
    size_ = new PropertyRow(document_, size, tr("Size"), 3, grid, form_);
    listen(*size_, &PropertiesPane::setSize);
}

// Of numbers that all of the selected have. A quaternion, which is one text, has none.
QString PropertiesPane::unitOf(const PropertyRow& row) const {
    const scene::Scene& scene = *document_.shown().scene;
    const std::string_view unit = editing::unitOf(scene, elements().front(), row.option().name);
    const bool isShared = std::ranges::all_of(elements(), [&](const Element& element) {
        return editing::unitOf(scene, element, row.option().name) == unit;
    });
    const bool isQuaternion = row.option().name == "-init_rot" && row.shown().size() == 1;
    return isShared && !isQuaternion ? toText(unit) : QString();
}

void PropertiesPane::showRow(PropertyRow& row) {
    row.setEnabled(properties_ != nullptr || !document_.hasErrors());
    if (!properties_)
        return row.setUnit(unitOf(row));
    row.setChoices(namesFor(row.option().wants));
    const QString source =
        elements().size() == 1
            ? QString::fromStdString(properties_->valueOf(elements().front(), row.option()).source)
            : QString();
    const PropertyParts shared = properties_->sharedValue(elements(), row.option());
    row.show(shared, absentOf(row.option()), source, differingIn(row, shared));
    row.setUnit(unitOf(row));
    row.setNote(faultsAt(row));
    const bool meets = row.option().name == "-restitution" && elements().front().kind == Kind::body;
    row.setRemark(meets ? tr("Of two bodies that meet the smaller one counts.") : QString());
}

// "0 … 1.5", where all are numbers; "b1: 0" and the like for each.
std::vector<DifferingPart> PropertiesPane::differingIn(const PropertyRow& row,
                                                       const PropertyParts& shared) const {
    const scene::Scene& scene = *document_.shown().scene;
    std::vector<DifferingPart> differing(shared.size());
    constexpr qsizetype most = 12; // lines
    for (std::size_t i = 0; i < shared.size(); ++i) {
        if (shared[i])
            continue;
        QStringList lines;
        double least = std::numeric_limits<double>::infinity(), largest = -least;
        bool areNumbers = true;
        for (const Element& element : elements()) {
            const auto parts = properties_->valueOf(element, row.option()).parts;
            QStringList words; // all of an expression or a vector where the others have another
            for (std::size_t k = 0; k < parts.size(); ++k)
                if (k == i || parts.size() != shared.size())
                    words << QString::fromStdString(parts[k]);
            const QString text = words.join(' ');
            const auto number = script::decimalNumber(text.toStdString());
            areNumbers = areNumbers && number;
            least = std::min(least, number.value_or(least));
            largest = std::max(largest, number.value_or(largest));
            const std::string name = editing::nameOf(scene, element);
            lines << QStringLiteral("%1: %2").arg(
                QString::fromStdString(name.empty() ? editing::describe(scene, element) : name),
                text.isEmpty() ? tr("none") : text);
        }
        if (lines.size() > most)
            lines = lines.first(most) << tr("and %1 more").arg(lines.size() - most);
        differing[i].each = lines.join('\n');
        differing[i].brief =
            areNumbers ? QStringLiteral("%1 … %2").arg(least, 0, 'g', 3).arg(largest, 0, 'g', 3)
                       : tr("different");
    }
    return differing;
}

// Faults of the text or the motion at the value that stands there.
QString PropertiesPane::faultsAt(const PropertyRow& row) const {
    QStringList faults;
    for (const Element& element : elements()) {
        const scene::Source* source = editing::sourceOf(*document_.shown().scene, element);
        for (const scene::Argument& argument :
             source ? source->arguments : std::vector<scene::Argument>())
            for (const scene::Diagnostic& one : document_.diagnostics())
                if (argument.option == row.option().name && argument.word.known() &&
                    argument.word.from <= one.range.from && one.range.to <= argument.word.to &&
                    one.range.known())
                    faults << QString::fromStdString(one.message);
    }
    faults.removeDuplicates();
    return faults.join('\n');
}

// As the motion has them, of those that are not fixed; "": it has none.
QString PropertiesPane::masses() const {
    const simulation::Motion* motion =
        document_.waitsToBeAsked() ? nullptr : document_.shown().motion.get();
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    for (const Element& body : elements()) {
        const bool isKnown = motion != nullptr && body.index < motion->bodies();
        const double mass = isKnown ? motion->mass(body.index) : 0;
        if (isKnown && !std::isfinite(mass))
            continue; // fixed
        least = std::min(least, mass);
        largest = std::max(largest, mass);
    }
    const QString from = QString::number(least, 'g', 6), to = QString::number(largest, 'g', 6);
    return !(largest > 0 && least > 0) ? QString()
           : from == to                ? from
                                       : QStringLiteral("%1 … %2").arg(from, to);
}

// The text gives each of them a mass.
bool PropertiesPane::hasMass() const {
    const auto& bodies = document_.shown().scene->bodies;
    return std::ranges::all_of(elements(), [&](const Element& one) {
        return one.kind == Kind::body && one.index < bodies.size() &&
               bodies[one.index].mass.has_value();
    });
}

QString PropertiesPane::absentOf(const OptionHint& option) const {
    if (option.name == "-mass")
        return masses();
    if (option.name == "-density" && hasMass())
        return {}; // it counts for nothing
    return option.wants == Wants::vector ? QString() : defaultIn(option.words);
}

QStringList PropertiesPane::namesFor(Wants wants) const {
    const scene::Scene& scene = *document_.shown().scene;
    switch (wants) {
    case Wants::body:
        return namesOf(scene.bodies);
    case Wants::shapeSet:
        return namesOf(scene.shapeSets);
    case Wants::trajectory:
        return namesOf(scene.trajectories);
    case Wants::joint:
        return namesOf(scene.joints);
    default:
        return {};
    }
}

// --- the attitude in degrees --------------------------------------------------------------------

void PropertiesPane::setUsualAxis(const geometry::Vector& axis) {
    if (axis == axis_.usual)
        return;
    axis_.usual = axis;
    if (isVisible())
        showTurn();
}

geometry::Vector PropertiesPane::axisNow() const { return axis_.typed.value_or(axis_.usual); }

PropertyParts PropertiesPane::turnParts(const std::vector<Element>& elements,
                                        const OptionHint& option) const {
    PropertyParts parts(4);
    std::optional<geometry::Vector> vector = vectorOf(properties_->sharedValue(elements, option));
    if (!vector && elements.size() == 1) // a quaternion
        if (const auto values = editing::valuesOf(*document_.shown().scene, elements.front(),
                                                  std::string(option.name)))
            vector = geometry::Vector((*values)[0], (*values)[1], (*values)[2]);
    if (vector) {
        const PropertyParts& shown = turn_->shown();
        const auto before = shown.size() == 4 && !vector->isZero()
                                ? vectorOf({shown[1], shown[2], shown[3]})
                                : std::nullopt;
        const editing::Turn turn = editing::turnOf(*vector, before.value_or(axisNow()));
        constexpr double written = 1e-7; // degrees: of a vector with nine decimals
        parts[0] = shownNumber(turn.degrees, written);
        for (int i = 0; i < 3; ++i)
            parts[static_cast<std::size_t>(i) + 1] = shownNumber(turn.axis[i], written);
    }
    return parts;
}

void PropertiesPane::showTurn() {
    if (!turn_ || !properties_)
        return;
    turn_->setEnabled(true);
    turn_->show(turnParts(elements(), turn_->option()), {}, {});
}

void PropertiesPane::setTurn(const Entered& entered) {
    const PropertyParts now = turnParts(entered.elements, *entered.option);
    const geometry::Vector usual = axisNow();
    double numbers[4] = {0, usual.x(), usual.y(), usual.z()};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string text = entered.parts[i].value_or(now[i].value_or(""));
        const auto number = text.empty() ? std::optional(numbers[i]) : script::decimalNumber(text);
        if (!number)
            return answer(entered, tr("Decimal numbers, please."));
        numbers[i] = *number;
    }
    const geometry::Vector axis(numbers[1], numbers[2], numbers[3]);
    if (axis.isZero())
        return answer(entered, tr("An axis has a direction: not 0 0 0."));
    axis_.typed = axis;
    if (numbers[0] == 0 && now[0] == "0") // the axis comes first
        return answer(entered, {});
    const geometry::Vector vector = editing::rotationVectorOf({numbers[0], axis});
    PropertyParts parts;
    for (int i = 0; i < 3; ++i)
        parts.push_back(shownNumber(vector[i]));
    write(entered, parts);
}

// --- the size of its shape ----------------------------------------------------------------------

void PropertiesPane::showSize() {
    if (!size_ || !properties_)
        return;
    const auto& bodies = document_.shown().scene->bodies;
    const bool haveOne = std::ranges::all_of(elements(), [&](const Element& one) { // shape
        return one.kind == Kind::body && one.index < bodies.size() &&
               bodies[one.index].shape == bodies[elements().front().index].shape;
    });
    const auto asked =
        haveOne ? commands::askedSize(document_.ground(), elements().front().index) : std::nullopt;
    size_->setVisible(asked.has_value());
    size_->setRemark(asked ? QString::fromStdString(asked->note) : QString());
    if (!asked)
        return;
    PropertyParts parts;
    for (const double one : asked->now)
        parts.emplace_back(shownNumber(one));
    size_->show(parts, {}, {});
    QStringList names;
    for (const std::string& one : asked->names)
        names << QString::fromStdString(one);
    size_->setNames(names);
}

void PropertiesPane::setSize(const Entered& entered) {
    const auto asked = commands::askedSize(document_.ground(), entered.elements.front().index);
    if (!asked)
        return answer(entered, tr("The shape has no one size."));
    std::vector<double> sizes = asked->now;
    for (std::size_t i = 0; i < sizes.size() && i < entered.parts.size(); ++i) {
        const auto& typed = entered.parts[i];
        const auto number = typed ? script::decimalNumber(*typed) : std::optional(sizes[i]);
        if (!number)
            return answer(entered, tr("Decimal numbers, please."));
        sizes[i] = *number;
    }
    tryEdits(entered, asked->answer(sizes), QString::fromStdString(asked->label));
}

// --- changes ------------------------------------------------------------------------------------

void PropertiesPane::listen(PropertyRow& row, Enter enter) {
    connect(&row, &PropertyRow::entered, this, [this, &row, enter](const PropertyParts& parts) {
        const Entered entered{&row, &row.option(), elements(), parts, head_->name().text()};
        later_.take(&row, [this, entered, now = following(document_, entered.elements), enter] {
            take(entered, now, enter);
        });
    });
}

void PropertiesPane::take(Entered entered, const Follow& now, Enter enter) {
    if (!document_.sceneIsCurrent())
        return answer(entered, document_.whyNotCurrent());
    const auto& scene = document_.shown().scene;
    const auto elements = now();
    if (!elements)
        return; // it was deleted meanwhile
    entered.elements = *elements;
    if (!properties_ || properties_->text() != document_.text())
        properties_ = std::make_unique<editing::Properties>(document_.text(), scene);
    (this->*enter)(entered);
}

void PropertiesPane::set(const Entered& entered) { write(entered, entered.parts); }

void PropertiesPane::write(const Entered& entered, const PropertyParts& parts) {
    const QString caption = QString::fromStdString(editing::captionOf(*entered.option));
    editing::Answer found = properties_->set(entered.elements, *entered.option, parts);
    if (entered.option->name == "-fixed" && parts.size() == 1 && parts.front())
        found = editing::withBounce(*properties_, *document_.shown().scene, entered.elements,
                                    parts.front() == "1", std::move(found));
    tryEdits(entered, found, tr("Change %1").arg(caption.toLower()));
}

void PropertiesPane::tryEdits(const Entered& entered, const editing::Answer& found,
                              const QString& label) {
    if (entered.row)
        entered.row->setOffers({}, {}, {});
    if (found.possible())
        return tryText(entered, found.edits, label);
    answer(entered, QString::fromStdString(found.reason));
    if (entered.row && entered.elements == shown_)
        entered.row->setOffers(
            document_.text(), found.offers,
            [this, entered, label](const text::Edits& edits) { tryText(entered, edits, label); });
}

void PropertiesPane::tryText(const Entered& entered, const text::Edits& edits,
                             const QString& label) {
    trial_.start(text::applied(document_.text(), edits), label,
                 [this, entered](const QString& why) { answer(entered, why); });
}

void PropertiesPane::answer(const Entered& entered, const QString& why) {
    const bool isShown = entered.row && entered.elements == shown_;
    if (isShown && why.isEmpty())
        entered.row->taken(entered.parts);
    else if (isShown)
        entered.row->refuse(entered.parts, why);
    else if (!why.isEmpty())
        head_->say(PropertyHead::meant(entered.name,
                                       QString::fromStdString(editing::captionOf(*entered.option)) +
                                           ": " + why));
    soon_.start();
}

} // namespace views
