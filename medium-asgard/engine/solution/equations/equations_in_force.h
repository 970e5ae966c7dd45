// The equations that a solver solves now: shared with other runs until an event changes them.
#pragma once

#include "expression/equations.h"

#include <memory>

namespace solution {

class EquationsInForce {
public:
    explicit EquationsInForce(std::shared_ptr<const expression::EquationSet> shared)
        : set_(std::move(shared)) {}

    [[nodiscard]] const expression::EquationSet& operator*() const { return *set_; }
    [[nodiscard]] const expression::EquationSet* operator->() const { return set_.get(); }
    // To be changed: an own copy from the first time on. Nodes keep their indices.
    [[nodiscard]] expression::EquationSet& changing() {
        if (!own_) {
            own_ = std::make_shared<expression::EquationSet>(*set_);
            set_ = own_;
        }
        return *own_;
    }

private:
    std::shared_ptr<const expression::EquationSet> set_;
    std::shared_ptr<expression::EquationSet> own_;
};

} // namespace solution
