// Makes the model of a document by one of its presentations, and keeps it in step with edits.
//
// The walk over the tree leaves checkpoints. After an edit it is taken up at the last one before
// the change, and goes on until it meets, behind the change, an old checkpoint with an equal
// state: from there on all is as it was. So a letter costs some hundred nodes however long the
// document is, and an edit costs as far as it reaches: a heading that is put in numbers all that
// follow it. A model that was followed is equal to one that is made anew.
//
// LIMIT: no checkpoint is inside a table, a footnote, what is kept together, or deep nesting
// (ModelWalk::deepestRest): an edit there walks over all of it.
#pragma once

#include "model/model_walk.h"
#include "model/references.h"
#include "sgml/change.h"

namespace model {

class ModelBuilder {
public:
    // All three are read as long as this lives. Another presentation, and a document whose class
    // has changed, take another builder. Styles are added to the table. `spacing`: nodes from one
    // checkpoint to the next.
    ModelBuilder(
        const document::Document& document, const schemas::Presentation& presentation,
        const schemas::Schemas& schemas,
        std::shared_ptr<schemas::TextStyles> styles = std::make_shared<schemas::TextStyles>(),
        int spacing = 100);

    // The values of subdocuments, read as long as this lives. Null: nobody knows any.
    void setValues(const ValueSource* values) { values_ = values; }
    // Some of them are others: false when this changes no block of the model.
    [[nodiscard]] bool followValues();

    // The document has changed; to be told of each change at once (Document::edited).
    void follow(const sgml::Change& change);
    // Walks over some more nodes; false: the model is that of the document.
    [[nodiscard]] bool step(int nodes);
    // The last one that was complete; null before the first.
    [[nodiscard]] const std::shared_ptr<const Model>& model() const { return model_; }
    // A copy of it, for those who do not follow.
    [[nodiscard]] Model take() const { return *model_; }

    // Counts of the work, for tests.
    struct Work {
        std::size_t nodes = 0;  // walked over
        std::size_t blocks = 0; // that are no blocks of the model before
    };
    [[nodiscard]] const Work& work() const { return work_; }

private:
    // Bytes of the file, before and after some changes: all nodes outside, and those around them,
    // are as they were.
    struct Region {
        std::size_t from = 0, to = 0, end = 0; // [from, to) became [from, end)
    };
    [[nodiscard]] Region regionOf(const sgml::Change& change) const;
    void begin();
    [[nodiscard]] bool meets();
    void finish();
    void join(Model& model);
    struct Spliced {
        std::size_t segments = 0; // of the walk
        bool renamed = false;     // some ID is referred to by another text
    };
    [[nodiscard]] Spliced spliceTrail();
    [[nodiscard]] bool resolve(Model& model, const Spliced& spliced);

    const document::Document& document_;
    const schemas::Presentation& presentation_;
    const schemas::Schemas& schemas_;
    std::shared_ptr<schemas::TextStyles> styles_;
    int spacing_;
    const ValueSource* values_ = nullptr;
    std::shared_ptr<const Model> model_;
    ModelWalk::Trail trail_;          // of the model
    References references_;           // of the model
    std::optional<Region> region_;    // that the model does not follow yet
    std::unique_ptr<ModelWalk> walk_; // under way
    std::size_t resumed_ = 0;         // index of the segment that it began with
    std::size_t ahead_ = 0;           // index of the next one that it may meet
    Work work_;
};

} // namespace model
