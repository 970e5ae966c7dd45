#include "plots/study_window.h"

#include "charts/study_chart.h"
#include "frame/help_menu.h"
#include "frame/session_actions.h"
#include "plain/plain.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QSaveFile>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

StudyWindow::StudyWindow(std::shared_ptr<const scene::Scene> scene, simulation::StudyPlan plan,
                         const QString& name)
    : scene_(std::move(scene)), plan_(std::move(plan)), name_(name) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("study");
    setWindowTitle(tr("%1 – Speed and Accuracy").arg(plain::title(name_)));
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    chart_ = plain::label();
    chart_->setAlignment(Qt::AlignCenter);
    chart_->setAutoFillBackground(true);
    QPalette paper = chart_->palette();
    paper.setColor(QPalette::Window, Qt::white); // as the chart
    chart_->setPalette(paper);
    chart_->setMinimumSize(450, 300);
    chart_->setAccessibleName(tr("Chart of error against time"));
    column->addWidget(chart_, 1);
    auto* row = new QHBoxLayout;
    words_ = plain::label();
    words_->setWordWrap(true);
    progress_ = new QProgressBar;
    progress_->setFixedWidth(160);
    progress_->setAccessibleName(tr("Runs measured"));
    stop_ = new QPushButton(tr("S&top"));
    stop_->setToolTip(tr("Keep what is measured, and measure no more"));
    connect(stop_, &QPushButton::clicked, this, [this] { cancelled_ = true; });
    save_ = new QPushButton(tr("&Save…"));
    save_->setToolTip(tr("The chart as SVG, PDF or PNG, or its numbers as CSV"));
    connect(save_, &QPushButton::clicked, this, &StudyWindow::askAndSave);
    row->addWidget(words_, 1);
    row->addWidget(progress_);
    row->addWidget(stop_);
    row->addWidget(save_);
    column->addLayout(row);
    setCentralWidget(whole);
    addHelpMenu(this, QStringLiteral("Speed and accuracy"));
    closeByEscape(*this);
    resize(940, 700);
    const std::size_t fixed = std::ranges::count_if(
        plan_.methods, [](const std::string& method) { return method != "auto"; });
    progress_->setMaximum(static_cast<int>(plan_.methods.size() * plan_.accuracies.size() +
                                           fixed * plan_.steps.size()));
    plan_.cancelled = [this] { return cancelled_.load(); };
    plan_.progress = [this](const auto& result) { publish(result, false); };
    take();
    thread_ = std::thread([this] { measure(); });
}

StudyWindow::~StudyWindow() {
    cancelled_ = true;
    thread_.join();
}

void StudyWindow::measure() { publish(simulation::study(*scene_, {}, plan_), true); }

void StudyWindow::publish(const simulation::StudyResult& result, bool done) {
    {
        const std::lock_guard lock(mutex_);
        published_ = result;
        done_ = done;
    }
    QMetaObject::invokeMethod(this, &StudyWindow::take, Qt::QueuedConnection);
}

void StudyWindow::take() {
    {
        const std::lock_guard lock(mutex_);
        shown_ = published_;
        measuring_ = !done_;
    }
    progress_->setValue(static_cast<int>(shown_.rows.size()));
    progress_->setVisible(measuring_);
    stop_->setVisible(measuring_);
    save_->setEnabled(!shown_.rows.empty());
    words_->setText(words());
    draw();
}

QString StudyWindow::words() const {
    if (!shown_.refusal.empty())
        return QString::fromStdString(shown_.refusal.front());
    if (shown_.rows.empty())
        return measuring_ ? tr("Computing the motion that the others are compared with…")
                          : tr("Nothing was measured.");
    if (measuring_)
        return tr("Measuring %1…").arg(QString::fromStdString(shown_.rows.back().method));
    if (!shown_.autoTakes.empty())
        return tr("On this scene auto takes %1.").arg(QString::fromStdString(shown_.autoTakes));
    return cancelled_ ? tr("Stopped: not all methods were measured.") : QString();
}

void StudyWindow::draw() {
    const double scale = chart_->devicePixelRatioF();
    const double perPoint =
        std::min(chart_->width() / charts::chartWidth, chart_->height() / charts::chartHeight);
    const charts::Pixels pixels = charts::pixelsOf(
        charts::chartOf(name_.toStdString(), plan_, shown_), std::max(0.3, perPoint * scale));
    if (pixels.colors.empty())
        return;
    QImage image(reinterpret_cast<const uchar*>(pixels.colors.data()), pixels.width, pixels.height,
                 4 * pixels.width, QImage::Format_RGB32);
    QPixmap pixmap = QPixmap::fromImage(image.copy());
    pixmap.setDevicePixelRatio(scale);
    chart_->setPixmap(pixmap);
}

void StudyWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    draw();
}

QString StudyWindow::save(const QString& path) const {
    if (!path.endsWith(QStringLiteral(".csv"))) {
        const std::string why =
            charts::draw(charts::chartOf(name_.toStdString(), plan_, shown_), path.toStdString());
        return why.empty() ? QString()
                           : tr("Cannot write %1: %2.").arg(path, QString::fromStdString(why));
    }
    QSaveFile file(path);
    const QByteArray table = QByteArray::fromStdString(charts::tableOf(shown_));
    if (!file.open(QIODevice::WriteOnly) || file.write(table) != table.size() || !file.commit())
        return tr("Cannot write %1: %2.").arg(path, file.errorString());
    return {};
}

void StudyWindow::askAndSave() {
    QFileDialog dialog(this, tr("Save the Chart"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({tr("Chart (*.svg *.pdf *.png)"), tr("Table of its numbers (*.csv)")});
    dialog.setDefaultSuffix(QStringLiteral("svg"));
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        dialog.setDefaultSuffix(filter.contains(QStringLiteral("csv")) ? QStringLiteral("csv")
                                                                       : QStringLiteral("svg"));
    });
    if (dialog.exec() != QDialog::Accepted)
        return;
    if (const QString fault = save(dialog.selectedFiles().front()); !fault.isEmpty())
        plain::Message::tell(QMessageBox::Critical, this, QStringLiteral("Asgard"), fault);
}

} // namespace views
