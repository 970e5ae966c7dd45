#include "paper/plain_text.h"

#include <QStringList>
#include <algorithm>

namespace paper {

namespace {

using Named = std::function<QString(document::SubdocumentId)>;

QString wrapped(const QString& text, const QString& first, const QString& rest) {
    QString result, line = first;
    bool empty = true;
    for (const QString& word : text.split(' ', Qt::SkipEmptyParts)) {
        if (!empty && line.size() + 1 + word.size() > textColumns) {
            result += line + '\n';
            line = rest;
            empty = true;
        }
        line += (empty ? QString() : QStringLiteral(" ")) + word;
        empty = false;
    }
    return result + line + '\n';
}

QString textOf(const std::vector<document::Run>& runs, const Named& named) {
    QString text;
    for (const document::Run& run : runs) {
        if (run.kind == document::RunKind::subdocument)
            text += '[' + named(run.subdocument) + ']';
        else if (run.kind == document::RunKind::footnote)
            text += '[' + QString::fromStdString(run.text) + ']';
        else if (run.kind == document::RunKind::lineBreak)
            text += '\n';
        else
            text += QString::fromStdString(run.text);
    }
    return text;
}

class Writer {
public:
    Writer(const document::Model& model, const Named& named) : model_(model), named_(named) {}

    QString all() {
        write(model_.blocks);
        if (!model_.footnotes.empty())
            out_ += "\n" + QString(20, '-') + "\n";
        for (const auto& note : model_.footnotes)
            write(note->blocks);
        return out_;
    }

private:
    static constexpr double pointsPerColumn = 6;

    void write(const document::Blocks& blocks) {
        for (const auto& block : blocks) {
            if (!out_.isEmpty() && (block->style.spaceBefore > 3 || lastAfter_ > 3))
                out_ += '\n';
            lastAfter_ = block->style.spaceAfter;
            write(*block);
        }
    }

    void write(const document::Block& block) {
        using document::BlockKind;
        const int indent =
            std::clamp(static_cast<int>(block.style.indentLeft / pointsPerColumn), 0, 40);
        const QString rest(indent, ' ');
        switch (block.kind) {
        case BlockKind::verbatim:
            for (const QString& line : textOf(block.runs, named_).split('\n'))
                out_ += rest + line + '\n';
            break;
        case BlockKind::subdocument:
            out_ += wrapped('[' + named_(block.subdocument) + ']', rest, rest);
            break;
        case BlockKind::image:
            out_ += wrapped("[" +
                                QString::fromStdString(
                                    block.alternative.empty() ? block.source : block.alternative) +
                                "]",
                            rest, rest);
            break;
        case BlockKind::rule:
            out_ += QString(textColumns, '-') + '\n';
            break;
        case BlockKind::pageBreak:
            out_ += '\n'; // a page ends for paper alone
            break;
        case BlockKind::table:
            writeTable(block);
            break;
        case BlockKind::text:
        case BlockKind::chart:
            writeText(block, rest);
            break;
        }
    }

    void writeText(const document::Block& block, const QString& rest) {
        const QString marker = QString::fromStdString(block.marker);
        QString first = rest;
        if (!marker.isEmpty() && marker.size() < first.size())
            first = QString(first.size() - marker.size() - 1, ' ') + marker + ' ';
        else if (!marker.isEmpty())
            first += marker + ' ';
        for (const QString& line : textOf(block.runs, named_).split('\n')) {
            out_ += wrapped(line, first, rest);
            first = rest;
        }
    }

    void writeTable(const document::Block& block) {
        std::vector<QStringList> rows;
        std::vector<qsizetype> widths;
        for (const document::Row& row : block.rows) {
            QStringList cells;
            for (const document::Cell& cell : row) {
                QStringList parts;
                for (const auto& inside : cell.blocks)
                    parts << textOf(inside->runs, named_).simplified();
                cells << parts.join(' ');
            }
            widths.resize(std::max(widths.size(), static_cast<std::size_t>(cells.size())), 0);
            for (int c = 0; c < cells.size(); ++c)
                widths[c] = std::max(widths[c], cells[c].size());
            rows.push_back(cells);
        }
        for (const QStringList& cells : rows) {
            QString line;
            for (int c = 0; c < cells.size(); ++c)
                line += cells[c].leftJustified(widths[c] + 3);
            out_ += line.trimmed().isEmpty() ? QStringLiteral("\n") : line.trimmed() + '\n';
        }
    }

    const document::Model& model_;
    const Named& named_;
    QString out_;
    double lastAfter_ = 0;
};

} // namespace

QString plainText(const document::Model& model, const Named& named) {
    return Writer(model, named).all();
}

} // namespace paper
