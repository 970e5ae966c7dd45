// Values for some nodes of a graph: a flat table, open addressing with linear probing.
#pragma once

#include "expression/graph.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace expression {

template <class T> class NodeMap {
public:
    // False: it is there already, and stays as it is.
    bool insert(Node n, T value) {
        if (2 * (size_ + 1) > entries_.size())
            grow();
        const std::size_t at = placeOf(n);
        if (entries_[at].key == n.index)
            return false;
        entries_[at] = {n.index, std::move(value)};
        ++size_;
        return true;
    }
    [[nodiscard]] const T* find(Node n) const {
        if (size_ == 0)
            return nullptr;
        const Entry& entry = entries_[placeOf(n)];
        return entry.key == n.index ? &entry.value : nullptr;
    }

private:
    static constexpr std::uint32_t nobody = static_cast<std::uint32_t>(-1);
    struct Entry {
        std::uint32_t key = nobody;
        T value{};
    };
    // Where it is, or the free place where it would be.
    [[nodiscard]] std::size_t placeOf(Node n) const {
        const std::size_t mask = entries_.size() - 1;
        std::size_t at = (n.index * std::size_t{0x9e3779b97f4a7c15u} >> 32) & mask;
        while (entries_[at].key != n.index && entries_[at].key != nobody)
            at = (at + 1) & mask;
        return at;
    }
    void grow() {
        std::vector<Entry> old(entries_.empty() ? 64 : 2 * entries_.size());
        old.swap(entries_);
        for (Entry& entry : old)
            if (entry.key != nobody)
                entries_[placeOf(Node{entry.key})] = std::move(entry);
    }

    std::vector<Entry> entries_;
    std::size_t size_ = 0;
};

} // namespace expression
