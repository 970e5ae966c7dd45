#include "language/fault_marks.h"

#include "language/scene_lexer.h"

#include <QListWidget>
#include <QStyle>

#include <algorithm>
#include <utility>

namespace views {

using scene::Range;

namespace {

constexpr int errorStyle = 40, warningStyle = 41;

QString sentence(const scene::Diagnostic& fault, const QString& between) {
    QString text = QString::fromStdString(fault.message);
    if (!fault.suggestion.empty())
        text += between + QString::fromStdString(fault.suggestion);
    return text;
}

bool isError(const scene::Diagnostic& fault) { return fault.severity == scene::Severity::error; }

} // namespace

FaultMarks::FaultMarks(SceneEditor& editor, QListWidget& list) : editor_(editor), list_(list) {
    editor_.addTool(this);
    list_.setAccessibleName(tr("Messages"));
    list_.setWordWrap(true);
    list_.setIconSize(QSize(16, 16));
    list_.setAlternatingRowColors(true);
    connect(&list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        const QPoint range = item->data(Qt::UserRole).toPoint();
        if (range.y() >= 0)
            Q_EMIT wanted(
                {static_cast<std::size_t>(range.x()), static_cast<std::size_t>(range.y())});
    });
    connect(&list_, &QListWidget::itemClicked, &list_, &QListWidget::itemActivated);
}

void FaultMarks::show(const std::vector<scene::Diagnostic>& faults, bool places) {
    list_.clear();
    if (places) {
        editor_.clearAnnotations();
        editor_.unmark(Mark::error);
        editor_.unmark(Mark::warning);
        placed_.clear();
    }
    for (const scene::Diagnostic& fault : faults) {
        list(fault, places);
        if (places)
            mark(fault);
    }
    list_.setVisible(list_.count() > 0);
    const auto first = std::ranges::find_if(placed_, isError);
    if (places && first != placed_.end() && std::exchange(expected_, false))
        Q_EMIT appeared(first->range);
}

void FaultMarks::hideNotes() { editor_.clearAnnotations(); }

void FaultMarks::list(const scene::Diagnostic& fault, bool places) {
    QString text = sentence(fault, QStringLiteral(" — "));
    if (fault.line > 0)
        text = tr("Line %1: %2").arg(fault.line).arg(text);
    auto* item = new QListWidgetItem(
        list_.style()->standardIcon(isError(fault) ? QStyle::SP_MessageBoxCritical
                                                   : QStyle::SP_MessageBoxWarning),
        text, &list_);
    const bool placed = fault.line > 0 && places;
    item->setData(Qt::UserRole, placed ? QPoint(static_cast<int>(fault.range.from),
                                                static_cast<int>(fault.range.to))
                                       : QPoint(-1, -1));
    item->setToolTip(placed ? tr("Enter or a click shows the place") : QString());
}

void FaultMarks::mark(const scene::Diagnostic& fault) {
    if (fault.line <= 0)
        return;
    editor_.mark(isError(fault) ? Mark::error : Mark::warning, fault.range);
    placed_.push_back(fault);
    QString note = sentence(fault, QStringLiteral("\n"));
    const QString before = editor_.annotation(fault.line - 1);
    if (!before.isEmpty())
        note = before + QLatin1Char('\n') + note;
    const bool dark = editor_.isDark(), error = isError(fault);
    const QColor paper = error ? (dark ? QColor(0x50, 0x28, 0x28) : QColor(0xFC, 0xE8, 0xE6))
                               : (dark ? QColor(0x4A, 0x3E, 0x1C) : QColor(0xFD, 0xF3, 0xD8));
    const QColor ink = error ? (dark ? QColor(0xF0, 0xB0, 0xA8) : QColor(0x8A, 0x1C, 0x14))
                             : (dark ? QColor(0xEC, 0xD0, 0x8C) : QColor(0x6E, 0x4C, 0x00));
    QFont font = editor_.lexer()->defaultFont(SceneLexer::plain);
    font.setPointSizeF(font.pointSizeF() * 0.92);
    editor_.annotate(fault.line - 1, note,
                     QsciStyle(error ? errorStyle : warningStyle, tr("Fault"), ink, paper, font));
}

// From the caret on, round the end.
void FaultMarks::next(bool forward) {
    std::vector<Range> all = editor_.marks(Mark::error);
    for (const Range& range : editor_.marks(Mark::warning))
        all.push_back(range);
    if (all.empty())
        return;
    std::ranges::sort(all, {}, &Range::from);
    const Range selected = editor_.selection();
    const auto after = std::ranges::find_if(all, [&](Range range) {
        return forward ? range.from >= std::max(selected.to, selected.from + 1)
                       : range.from >= selected.from;
    });
    if (forward)
        Q_EMIT wanted(after == all.end() ? all.front() : *after);
    else
        Q_EMIT wanted(after == all.begin() ? all.back() : *(after - 1));
}

QString FaultMarks::tip(std::size_t byte) const {
    if (!editor_.isMarked(Mark::error, byte) && !editor_.isMarked(Mark::warning, byte))
        return {};
    for (const scene::Diagnostic& fault : placed_)
        if (fault.range.from <= byte && byte < fault.range.to)
            return sentence(fault, QStringLiteral("\n"));
    return {};
}

} // namespace views
