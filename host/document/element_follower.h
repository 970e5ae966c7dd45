// A class that keeps something of each element follows a change by looking again at the elements
// that the change reached, and at no other.
#pragma once

#include "document/document.h"

#include <unordered_map>

namespace document {

class ElementFollower {
public:
    virtual ~ElementFollower() = default;
    ElementFollower(const ElementFollower&) = delete;
    ElementFollower& operator=(const ElementFollower&) = delete;

    // After the tree has followed (Document::edited).
    void follow(const sgml::Change& change);
    // So many elements and documents were looked at, for tests.
    [[nodiscard]] std::size_t looked() const { return looked_; }

protected:
    explicit ElementFollower(const Document& document) : document_(document) {}
    [[nodiscard]] const Document& document() const { return document_; }
    [[nodiscard]] const sgml::Tree& tree() const { return document_.tree(); }
    void lookAtAll();

    // An element that came, or whose start tag or children changed. `in`: the innermost document
    // around it, noNode where a <DOCUMENT> holds it directly.
    virtual void look(sgml::NodeId element, sgml::NodeId in) = 0;
    // A document that came, or whose class, class element or its start tag changed.
    virtual void lookAtDocument(sgml::NodeId) {}
    // A node that is gone.
    virtual void forget(sgml::NodeId node) = 0;
    virtual void forgetAll() = 0;

private:
    void lookAgain(sgml::NodeId node);
    void lookBelow(sgml::NodeId top);
    void lookAtDocumentAgain(sgml::NodeId node);
    [[nodiscard]] sgml::NodeId documentAround(sgml::NodeId node) const;

    const Document& document_;
    std::unordered_map<sgml::NodeId, std::string> classes_; // of each document
    std::size_t looked_ = 0;
};

} // namespace document
