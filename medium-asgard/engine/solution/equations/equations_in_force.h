// The equations that a solver solves now: shared with other runs until an event changes them.
#pragma once

#include "equations/partition.h"
#include "expression/equations.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace solution {

class EquationsInForce {
public:
    EquationsInForce(std::shared_ptr<const expression::EquationSet> set,
                     std::shared_ptr<const UnknownIndex> index)
        : set_(std::move(set)), index_(std::move(index)) {}

    [[nodiscard]] const expression::EquationSet& operator*() const { return *set_; }
    [[nodiscard]] const expression::EquationSet* operator->() const { return set_.get(); }
    [[nodiscard]] const UnknownIndex& index() const { return *index_; }
    // As they are now, never to change again.
    [[nodiscard]] std::shared_ptr<const expression::EquationSet> shared() {
        own_.reset();
        return set_;
    }
    // To be changed: an own copy from the first time on. Nodes keep their indices.
    [[nodiscard]] expression::EquationSet& changing() {
        if (!own_) {
            own_ = std::make_shared<expression::EquationSet>(*set_);
            set_ = own_;
        }
        return *own_;
    }
    void add(expression::Unknown unknown) {
        changing().unknowns.push_back(std::move(unknown));
        changingIndex().add(*set_, set_->unknowns.size() - 1);
    }
    // From that time on the unknown has this phase, and then these.
    void replace(std::size_t unknown, const expression::Phase& phase,
                 const std::vector<expression::Phase>& later) {
        std::vector<expression::Phase>& phases = changing().unknowns[unknown].phases;
        const auto isMultiplier = [](const expression::Phase& p) {
            return p.condition.has_value();
        };
        const bool wasOne = std::ranges::any_of(phases, isMultiplier);
        std::erase_if(phases, [&](const expression::Phase& p) { return p.from >= phase.from; });
        phases.push_back(phase);
        phases.insert(phases.end(), later.begin(), later.end());
        if (wasOne || isMultiplier(phase))
            changingIndex().follow(*set_, unknown, phase.from);
        if (index_->isRelease(unknown))
            changingIndex().followRelease(*set_, unknown);
    }

    // From that time on the reading is this one.
    void replace(std::size_t reading, double from, expression::Node node) {
        std::vector<expression::Reading::Value>& values = changing().readings[reading].values;
        std::erase_if(values, [&](const auto& value) { return value.from >= from; });
        values.push_back({from, node});
    }

private:
    [[nodiscard]] UnknownIndex& changingIndex() {
        if (!ownIndex_) {
            ownIndex_ = std::make_shared<UnknownIndex>(*index_);
            index_ = ownIndex_;
        }
        return *ownIndex_;
    }

    std::shared_ptr<const expression::EquationSet> set_;
    std::shared_ptr<expression::EquationSet> own_;
    std::shared_ptr<const UnknownIndex> index_;
    std::shared_ptr<UnknownIndex> ownIndex_;
};

} // namespace solution
