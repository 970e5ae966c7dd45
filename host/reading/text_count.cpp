#include "reading/text_count.h"

#include <QString>
#include <QTextBoundaryFinder>

namespace reading {

using model::Block, model::Blocks, model::Run, model::RunKind, model::Footnote, model::Cell,
    model::Row;

namespace {

class Counting {
public:
    void add(const Blocks& blocks) {
        for (const std::shared_ptr<const Block>& block : blocks)
            add(*block);
    }
    TextCount count;

private:
    void add(const Block& block) {
        QString text;
        for (const Run& run : block.runs)
            if (run.content != sgml::noNode && run.kind == RunKind::text)
                text += QString::fromStdString(run.text);
            else if (run.kind != RunKind::footnote)
                text += '\n'; // words on both its sides are two
        add(text);
        for (const Row& row : block.rows)
            for (const Cell& cell : row)
                add(cell.blocks);
    }
    void add(const QString& text) {
        QTextBoundaryFinder words(QTextBoundaryFinder::Word, text);
        do
            count.words += words.boundaryReasons().testFlag(QTextBoundaryFinder::StartOfItem);
        while (words.toNextBoundary() >= 0);
        QTextBoundaryFinder characters(QTextBoundaryFinder::Grapheme, text);
        for (qsizetype from = 0, to = 0; (to = characters.toNextBoundary()) >= 0; from = to) {
            if (text[from] == '\n')
                continue;
            ++count.characters;
            count.notBlank += text[from].isSpace() ? 0 : 1;
        }
    }
};

} // namespace

TextCount countText(const Model& model) {
    Counting counting;
    counting.add(model.blocks);
    for (const std::shared_ptr<const Footnote>& note : model.footnotes)
        counting.add(note->blocks);
    return counting.count;
}

} // namespace reading
