// Writes expressions into the key of a model (component_model.h), arguments before what reads them.
//
// Unknowns that stay 0 are put in as a 0, and terms of numbers alone are numbers. Linear in the
// size of the expressions, whatever else the graph has.
#pragma once

#include "equations/component_model.h"
#include "equations/zero_states.h"
#include "expression/graph.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace solution {

class KeyWriter {
public:
    // A number, or an entry of the key.
    struct Operand {
        bool isNumber = false;
        double number = 0;
        std::uint32_t entry = 0;
        [[nodiscard]] bool is(double value) const { return isNumber && number == value; }
    };
    [[nodiscard]] static Operand number(double value) { return {true, value, 0}; }

    // `symbolOf` writes a symbol that is met for the first time, by leaf(), or says its number.
    KeyWriter(const expression::Graph& graph, const ZeroStates& zero,
              std::function<Operand(expression::Node)> symbolOf)
        : graph_(graph), zero_(zero), symbolOf_(std::move(symbolOf)) {}

    [[nodiscard]] Operand operandOf(expression::Node root);
    [[nodiscard]] std::uint32_t entryOf(const Operand& operand);
    // Of a node, from now on.
    void put(expression::Node node, const Operand& operand) { done_.insert(node.index, operand); }
    Operand leaf(std::uint32_t kind, std::optional<std::uint32_t> which = {});
    // Of `count` operands, which the graph need not have together.
    Operand apply(expression::Op op, const std::array<Operand, 3>& a, std::size_t count);
    // Words between entries.
    void add(std::initializer_list<std::uint32_t> words) { key_.insert(key_.end(), words); }
    void add(const std::vector<std::uint32_t>& words) {
        key_.insert(key_.end(), words.begin(), words.end());
    }
    [[nodiscard]] const ComponentModel::Key& key() const { return key_; }
    // Values of the key's constants, in order.
    [[nodiscard]] const std::vector<double>& constants() const { return constants_; }

private:
    // Numbers for a few nodes of a large graph.
    template <class Value> class Table {
    public:
        Table() : slots_(128, {none, {}}) {}
        [[nodiscard]] const Value* find(std::uint64_t key) const {
            for (std::size_t i = start(key);; i = (i + 1) & (slots_.size() - 1)) {
                if (slots_[i].first == key)
                    return &slots_[i].second;
                if (slots_[i].first == none)
                    return nullptr;
            }
        }
        void insert(std::uint64_t key, Value value) {
            if (2 * ++count_ > slots_.size()) {
                std::vector<std::pair<std::uint64_t, Value>> old(2 * slots_.size(), {none, {}});
                old.swap(slots_);
                for (const auto& slot : old)
                    if (slot.first != none)
                        place(slot);
            }
            place({key, value});
        }

    private:
        // No bits of a finite number and no index of a node.
        static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
        [[nodiscard]] std::size_t start(std::uint64_t key) const {
            return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32) &
                   (slots_.size() - 1);
        }
        void place(const std::pair<std::uint64_t, Value>& slot) {
            std::size_t i = start(slot.first);
            while (slots_[i].first != none)
                i = (i + 1) & (slots_.size() - 1);
            slots_[i] = slot;
        }
        std::vector<std::pair<std::uint64_t, Value>> slots_;
        std::size_t count_ = 0;
    };

    [[nodiscard]] Operand made(expression::Node n);
    [[nodiscard]] std::uint32_t literal(double value);

    const expression::Graph& graph_;
    const ZeroStates& zero_;
    std::function<Operand(expression::Node)> symbolOf_;
    ComponentModel::Key key_;
    std::vector<double> constants_;
    std::uint32_t entries_ = 0;
    std::vector<expression::Node> stack_;
    Table<Operand> done_;          // by node
    Table<std::uint32_t> numbers_; // by bits
};

} // namespace solution
