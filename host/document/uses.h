// The elements of a document that show the picture of a file, drive a parameter of a subdocument,
// show a value of one, or hold a formula. They are sound only if file, parameter and value are
// there, and the formula can be read.
#pragma once

#include "document/element_follower.h"
#include "schemas/schemas.h"

#include <set>

namespace document {

struct ImageUse {
    text::Range range; // of the start tag
    std::string source;
};
struct SliderUse {
    text::Range range; // of the start tag
    SubdocumentId subdocument = noSubdocument;
    std::string parameter;
};

class Uses final : public ElementFollower {
public:
    Uses(const Document& document, const schemas::Schemas& schemas);

    // In order of place.
    [[nodiscard]] std::vector<ImageUse> images() const;
    [[nodiscard]] std::vector<SliderUse> sliders() const;
    [[nodiscard]] std::vector<sgml::NodeId> formulas() const; // their contents
    [[nodiscard]] std::vector<sgml::NodeId> values() const;   // the elements

private:
    using Names = std::set<std::string, std::less<>>;
    struct Shown {
        Names images, sliders, formulas, values;
    };
    void look(sgml::NodeId element, sgml::NodeId in) override;
    void forget(sgml::NodeId node) override;
    void forgetAll() override;
    [[nodiscard]] const Shown& shownIn(sgml::NodeId document);
    [[nodiscard]] std::vector<sgml::NodeId> inOrder(const std::set<sgml::NodeId>& nodes) const;

    const schemas::Schemas& schemas_;
    std::map<std::string, Shown, std::less<>> classes_; // what their presentations show so
    std::set<sgml::NodeId> images_, sliders_, formulas_, values_;
};

} // namespace document
