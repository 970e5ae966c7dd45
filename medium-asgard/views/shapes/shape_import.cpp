#include "shapes/shape_import.h"

#include "editing/number_text.h"
#include "plain/plain.h"
#include "point_edits/shape_edit.h"
#include "script/numbers.h"

#include "shapes/shape_display.h"
#include "shapes/shape_gesture.h"
#include "shapes/shape_names.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace views {

using geometry::Vector;

namespace {

// More than these make a scene slow: bodies that come near each other compare all their parts.
constexpr std::size_t manyParts = 40, manyVertices = 800;

QString rough(double value) { return QString::number(value, 'g', 4); }

std::size_t verticesOf(const meshes::ConvexParts& made) {
    std::size_t all = 0;
    for (const auto& part : made.parts)
        all += part.size();
    return all;
}

QLabel* wrapped() {
    auto* label = plain::label();
    label->setWordWrap(true);
    return label;
}

QSpinBox* countField(int least, int most, int value) {
    auto* field = new QSpinBox;
    field->setRange(least, most);
    field->setValue(value);
    field->setKeyboardTracking(false);
    return field;
}

} // namespace

ShapeImport::ShapeImport(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                         const QString& path, QWidget* parent)
    : QDialog(parent), document_(document), file_(QFileInfo(path).fileName()), job_(path),
      display_(new ShapeDisplay(std::move(pictures))), facts_(wrapped()), size_(wrapped()),
      words_(wrapped()),
      name_(new QLineEdit(unusedShapeName(document, QFileInfo(path).completeBaseName()))),
      scale_(new QLineEdit(QStringLiteral("1"))), centred_(new QCheckBox(tr("&Middle at 0 0 0"))),
      surplus_(new QDoubleSpinBox), parts_(countField(1, 500, 32)),
      points_(countField(4, 1000, 48)), progress_(new QProgressBar),
      fewer_(new QPushButton(tr("&Use Fewer"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("shapeImport");
    setWindowTitle(tr("Import %1").arg(plain::title(file_)));
    display_->setForLooking();
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 12, 12, 12);
    row->setSpacing(12);
    row->addWidget(display_, 1);
    row->addWidget(buildSide());
    connect(&job_, &MeshJob::progressed, this, [this](double share) {
        progress_->setRange(0, 100);
        progress_->setValue(static_cast<int>(100 * share));
    });
    connect(&job_, &MeshJob::finished, this, [this] { showResult(job_.result()); });
    connect(fewer_, &QPushButton::clicked, this, &ShapeImport::useFewer);
    connect(name_, &QLineEdit::textChanged, this, &ShapeImport::showFault);
    connect(scale_, &QLineEdit::textChanged, this, &ShapeImport::showParts);
    connect(centred_, &QCheckBox::toggled, this, &ShapeImport::showParts);
    connect(surplus_, &QDoubleSpinBox::valueChanged, this, &ShapeImport::ask);
    for (QSpinBox* field : {parts_, points_})
        connect(field, &QSpinBox::valueChanged, this, &ShapeImport::ask);
    ask();
    resize(860, 560);
}

QWidget* ShapeImport::buildSide() {
    auto* side = new QWidget;
    side->setFixedWidth(290);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    facts_->setAccessibleName(tr("The file"));
    column->addWidget(facts_);
    column->addSpacing(6);
    auto* form = new QFormLayout;
    buildWishes(form);
    column->addLayout(form);
    column->addSpacing(6);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    progress_->setAccessibleName(tr("How far the parts are computed"));
    column->addWidget(progress_);
    words_->setAccessibleName(tr("What it becomes"));
    words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    words_->setMinimumHeight(6 * words_->fontMetrics().height());
    column->addWidget(words_);
    column->addWidget(fewer_, 0, Qt::AlignLeft);
    column->addStretch();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    import_ = buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &ShapeImport::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    return side;
}

void ShapeImport::buildWishes(QFormLayout* form) {
    form->addRow(tr("&Name"), name_);
    scale_->setToolTip(tr("Every length of the file times this; 0.001 for millimetres"));
    form->addRow(tr("&Scale"), scale_);
    form->addRow(QString(), size_);
    centred_->setChecked(true);
    centred_->setToolTip(
        tr("Moves the shape so that the middle of the box about it is the origin"));
    form->addRow(QString(), centred_);
    surplus_->setRange(0.01, 100);
    surplus_->setDecimals(2);
    surplus_->setValue(2);
    surplus_->setSuffix(tr(" %"));
    surplus_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    surplus_->setKeyboardTracking(false);
    surplus_->setToolTip(tr("How much more volume the parts may fill than the file does"));
    form->addRow(tr("&Volume too much"), surplus_);
    parts_->setToolTip(tr("The largest number of parts, whatever the volume"));
    form->addRow(tr("&Parts at most"), parts_);
    points_->setToolTip(
        tr("The largest number of vertices of one part; rounder parts lose a little"));
    form->addRow(tr("V&ertices of each"), points_);
}

// --- what it becomes ---------------------------------------------------------------------------

void ShapeImport::ask() {
    progress_->setRange(0, 0);
    progress_->show();
    words_->setText(tr("Looking for convex parts…"));
    fewer_->hide();
    import_->setEnabled(false);
    meshes::Wanted wanted;
    wanted.surplus = surplus_->value() / 100;
    wanted.parts = static_cast<std::size_t>(parts_->value());
    wanted.points = static_cast<std::size_t>(points_->value());
    job_.start(wanted);
}

bool ShapeImport::ready() const { return !job_.running() && job_.result().fault.isEmpty(); }

QString ShapeImport::words() const { return words_->text(); }

void ShapeImport::showResult(const MeshResult& result) {
    progress_->setRange(0, 100);
    progress_->setValue(result.fault.isEmpty() ? 100 : 0);
    if (!result.fault.isEmpty()) {
        words_->setText(result.fault);
        return;
    }
    QString facts = result.solids == 1 ? tr("%1 triangles, one solid.").arg(result.triangles)
                    : result.solids > 1
                        ? tr("%1 triangles, %2 solids.").arg(result.triangles).arg(result.solids)
                        : tr("%1 triangles.").arg(result.triangles);
    if (result.openPieces > 0)
        facts += tr("\n%1 of its pieces are open (%2 edges lack a neighbour) and bound no volume: "
                    "each is taken as its hull.")
                     .arg(result.openPieces)
                     .arg(result.openEdges);
    facts_->setText(facts);
    showParts();
    display_->frame();
}

void ShapeImport::showParts() {
    const auto scale = script::decimalNumber(scale_->text().toStdString());
    made_.clear();
    import_->setEnabled(false);
    if (!ready())
        return;
    size_->setText(sizeText());
    constexpr double far = 1e9; // no shape is larger
    const double size = (job_.result().high - job_.result().low).cwiseAbs().maxCoeff();
    if (!scale || *scale <= 0 || !(*scale * size < far))
        return words_->setText(tr("A scale is a number above 0, of a shape below 1e9."));
    made_ = parts();
    tooLong_ = faultOfLength();
    display_->setParts(made_);
    const meshes::ConvexParts& made = job_.result().made;
    const bool many = made.parts.size() > manyParts || verticesOf(made) > manyVertices;
    fewer_->setVisible(many);
    showFault();
}

void ShapeImport::showFault() {
    import_->setEnabled(false);
    if (made_.empty())
        return;
    const QString fault = faultOfShapeName(document_, name_->text());
    const QString why = fault.isEmpty() ? tooLong_ : fault;
    words_->setText(why.isEmpty() ? resultText() : why);
    import_->setEnabled(why.isEmpty());
}

// Some of them are written, from the first to the last; all have as many bytes for each vertex.
double lengthInText(const std::vector<scene::Part>& parts) {
    const auto vertices = [](const std::vector<scene::Part>& some) {
        double count = 0;
        for (const scene::Part& part : some)
            if (const auto* hull = std::get_if<scene::HullShape>(&part.shape))
                count += static_cast<double>(hull->points.size());
        return std::max(count, 1.0);
    };
    constexpr std::size_t most = 10;
    constexpr double each = 30; // of what stands about the vertices
    const std::size_t step = parts.size() / most + 1;
    std::vector<scene::Part> some;
    for (std::size_t i = 0; i < parts.size(); i += step)
        some.push_back(parts[i]);
    const double written = static_cast<double>(editing::descriptionText(some).size()) -
                           each * static_cast<double>(some.size());
    return std::max(written, 0.0) / vertices(some) * vertices(parts) +
           each * static_cast<double>(parts.size());
}

// A longer text is read by nobody.
QString ShapeImport::faultOfLength() const {
    constexpr double most = 8 << 20; // bytes, of script::Reader
    const double bytes = lengthInText(made_);
    const double already = static_cast<double>(document_.text().size());
    if (already + 1.05 * bytes < most)
        return {};
    return tr("That is %1 MB of text beside the scene's %2 MB; a scene has at most 8. "
              "Ask for fewer parts or vertices.")
        .arg(bytes / (1 << 20), 0, 'g', 2)
        .arg(already / (1 << 20), 0, 'g', 2);
}

QString ShapeImport::sizeText() const {
    const double scale = script::decimalNumber(scale_->text().toStdString()).value_or(0);
    const Vector size = scale * (job_.result().high - job_.result().low);
    return tr("%1 × %2 × %3").arg(rough(size.x()), rough(size.y()), rough(size.z()));
}

QString ShapeImport::resultText() const {
    const meshes::ConvexParts& made = job_.result().made;
    const std::size_t vertices = verticesOf(made);
    const double more = 100 * (made.partsVolume / made.volume - 1);
    QString text =
        made.parts.size() == 1
            ? tr("One convex part with %1 vertices").arg(vertices)
            : tr("%1 convex parts with %2 vertices").arg(made.parts.size()).arg(vertices);
    text += std::abs(more) < 0.005 ? tr("; the file's volume.")
            : more > 0             ? tr("; %1 % more volume than the file's.").arg(more, 0, 'f', 2)
                       : tr("; %1 % less volume than the file's.").arg(-more, 0, 'f', 2);
    if (more > surplus_->value() + 0.5)
        text += tr("\nMore parts would come nearer.");
    if (made.flat > 0)
        text += tr("\n%1 flat pieces are left out.").arg(made.flat);
    if (fewer_->isVisibleTo(this))
        text += tr("\nCollisions of such a body are slow: where two bodies come near each other, "
                   "all their parts are compared.");
    return text;
}

std::vector<scene::Part> ShapeImport::parts() const {
    const MeshResult& result = job_.result();
    const double scale = script::decimalNumber(scale_->text().toStdString()).value_or(1);
    const Vector origin =
        centred_->isChecked() ? Vector((result.low + result.high) / 2) : Vector(Vector::Zero());
    const double step = editing::decimalStep(1e-6 * scale * (result.high - result.low).maxCoeff());
    std::vector<scene::Part> parts;
    for (const auto& points : result.made.parts) {
        scene::HullShape hull;
        for (const Vector& p : points)
            hull.points.push_back(decimal(Vector(scale * (p - origin)), step));
        scene::Part part;
        part.shape = hull;
        parts.push_back(part);
    }
    return parts;
}

void ShapeImport::useFewer() {
    const QSignalBlocker quietParts(parts_), quietPoints(points_);
    const auto now = static_cast<int>(job_.result().made.parts.size());
    parts_->setValue(std::clamp(now / 2, 1, static_cast<int>(manyParts) / 2));
    points_->setValue(std::min(points_->value(), 24));
    ask();
}

void ShapeImport::accept() {
    if (!import_->isEnabled())
        return;
    const QString name = name_->text();
    const QString fault =
        makeShape(document_, name, parts(), tr("Import %1").arg(plain::title(file_)));
    if (!fault.isEmpty()) {
        words_->setText(fault);
        return;
    }
    Q_EMIT imported(name);
    QDialog::accept();
}

ShapeImport* importShape(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                         QWidget* parent) {
    const QString path = QFileDialog::getOpenFileName(
        parent, ShapeImport::tr("Import a shape"), QFileInfo(document.path()).absolutePath(),
        ShapeImport::tr("Meshes (*.stl *.STL *.obj *.OBJ);;All files (*)"));
    if (path.isEmpty())
        return nullptr;
    auto* dialog = new ShapeImport(document, std::move(pictures), path, parent);
    dialog->open();
    return dialog;
}

} // namespace views
