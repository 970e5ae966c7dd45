#include "expression/visited.h"

#include <algorithm>

namespace expression {

std::vector<std::unique_ptr<Visited::Table>>& Visited::freeTables() {
    thread_local std::vector<std::unique_ptr<Table>> tables;
    return tables;
}

Visited::Visited() {
    auto& tables = freeTables();
    if (tables.empty()) {
        table_ = std::make_unique<Table>();
    } else {
        table_ = std::move(tables.back());
        tables.pop_back();
    }
    if (++table_->walk == 0) { // all numbers of walks were used
        std::ranges::fill(table_->last, 0U);
        table_->walk = 1;
    }
}

Visited::~Visited() { freeTables().push_back(std::move(table_)); }

} // namespace expression
