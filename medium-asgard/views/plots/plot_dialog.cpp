#include "plots/plot_dialog.h"

#include "commands/proposal.h"
#include "plain/plain.h"
#include "scene/names.h"

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace views {

namespace {

// What expressions can name, and nothing else: shapes are large.
scene::Scene namesOf(const scene::Scene& scene) {
    scene::Scene names;
    for (const scene::Body& body : scene.bodies)
        names.bodies.emplace_back().name = body.name;
    for (const scene::Link& link : scene.links) {
        scene::Link& named = names.links.emplace_back();
        named.name = link.name;
        named.spring = link.spring;
    }
    for (const scene::Joint& joint : scene.joints) {
        scene::Joint& named = names.joints.emplace_back();
        named.name = joint.name;
        named.type = joint.type;
    }
    for (const scene::Gear& gear : scene.gears)
        names.gears.emplace_back().name = gear.name;
    for (const scene::Rope& rope : scene.ropes) {
        scene::Rope& named = names.ropes.emplace_back();
        named.name = rope.name;
        named.points = rope.points;
        named.isClosed = rope.isClosed;
    }
    for (const scene::Contact& contact : scene.contacts)
        names.contacts.emplace_back().name = contact.name;
    for (const scene::Trajectory& trajectory : scene.trajectories)
        names.trajectories.emplace_back().name = trajectory.name;
    for (const scene::Parameter& parameter : scene.parameters)
        names.parameters.emplace_back().name = parameter.name;
    return names;
}

} // namespace

QString faultOfPlotted(const scene::Scene& scene, const QString& expression) {
    // A bracket that is not closed would take the rest of the text with it; expressions have none.
    static const QRegularExpression foreign(QStringLiteral("[{}\\[\\]\"\\\\$;#\n]"));
    if (expression.contains(foreign))
        return PlotDialog::tr(
            "An expression has no braces, brackets, quotes, backslashes, $, # and semicolons.");
    scene::Scene asked = namesOf(scene);
    scene::Plot& plot = asked.plots.emplace_back();
    plot.name = "plot";
    plot.values = {expression.toStdString()};
    const auto faults = scene::checkExpressions(asked);
    if (faults.empty())
        return {};
    const scene::ExpressionFault& fault = faults.front();
    QString words = QString::fromStdString(fault.message);
    if (!fault.suggestion.empty())
        words += " (" + QString::fromStdString(fault.suggestion) + ")";
    return words;
}

PlotDialog::PlotDialog(const Shown& shown, QWidget* parent,
                       const std::optional<editing::Element>& about)
    : QDialog(parent), scene_(shown.scene), field_(new QLineEdit), fault_(plain::label()) {
    setObjectName("newPlot");
    field_->setObjectName("expression");
    setWindowTitle(tr("New Plot"));
    auto* column = new QVBoxLayout(this);
    field_->setText(QStringLiteral("t"));
    list_ = makeList(shown.motion.get(), about);
    auto* lists = plain::label(tr("&Quantity, against time:"));
    lists->setBuddy(list_);
    auto* asks = plain::label(tr("&Expression:"));
    asks->setBuddy(field_);
    asks->setToolTip(plain::tip(tr("Also what a calculator takes: 0.5 * b1.mass * b1.dy^2")));
    field_->selectAll();
    field_->setFocus();
    fault_->setWordWrap(true);
    fault_->setStyleSheet(QStringLiteral("color: #aa1e14"));
    fault_->setMinimumHeight(2 * fault_->fontMetrics().height()); // what is below stays
    fault_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    column->addWidget(lists);
    column->addWidget(list_, 1);
    column->addWidget(asks);
    column->addWidget(field_);
    column->addWidget(fault_);
    column->addWidget(buttons);
    for (QWidget* one : std::initializer_list<QWidget*>{lists, list_})
        one->setVisible(list_->topLevelItemCount() > 0);
    connect(field_, &QLineEdit::textChanged, fault_, &QLabel::clear); // not while one types
    connect(buttons, &QDialogButtonBox::accepted, this, &PlotDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(420);
}

// From its beginning on, as far as it shows what is proposed: how high it is becomes known here.
void PlotDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    list_->scrollToTop();
    if (const QTreeWidgetItem* proposed = list_->currentItem())
        list_->scrollToItem(proposed);
}

// The quantities below their elements; the one that is chosen stands in the field.
QTreeWidget* PlotDialog::makeList(const simulation::Motion* motion,
                                  const std::optional<editing::Element>& about) {
    auto* list = new QTreeWidget;
    list->setObjectName("quantities");
    list->setHeaderHidden(true);
    list->setColumnCount(2);
    connect(list, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* now) {
        if (now && now->childCount() == 0)
            field_->setText(now->text(1));
    });
    connect(list, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* one) {
        if (one->childCount() == 0)
            accept();
    });
    const auto all = commands::quantitiesOf(*scene_);
    const auto proposal = commands::proposalOf(*scene_, motion, all, about);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const commands::Measured& one = all[i];
        auto* element = new QTreeWidgetItem(
            list, {QString::fromStdString(editing::describe(*scene_, one.element))});
        for (const commands::Quantity& quantity : one.quantities)
            (new QTreeWidgetItem(element, {QString::fromStdString(worded(quantity)),
                                           QString::fromStdString(quantity.expression)}))
                ->setData(0, Qt::UserRole, QString::fromStdString(quantity.name));
        constexpr std::size_t few = 6; // elements: their quantities are seen at once
        element->setExpanded(all.size() <= few || one.element == about || i == proposal->measured);
    }
    list->resizeColumnToContents(0);
    list->setMinimumHeight(14 * list->fontMetrics().height());
    if (proposal)
        list->setCurrentItem(list->topLevelItem(static_cast<int>(proposal->measured))
                                 ->child(static_cast<int>(proposal->quantity)));
    return list;
}

QString PlotDialog::name() const {
    const QTreeWidgetItem* chosen = list_->currentItem();
    return chosen && chosen->text(1) == expression() ? chosen->data(0, Qt::UserRole).toString()
                                                     : QString();
}

QString PlotDialog::expression() const { return field_->text().trimmed(); }

void PlotDialog::accept() {
    const QString fault = expression().isEmpty() ? tr("An expression, please: b1.y, t, a + b.")
                                                 : faultOfPlotted(*scene_, expression());
    fault_->setText(fault);
    if (fault.isEmpty())
        QDialog::accept();
}

} // namespace views
