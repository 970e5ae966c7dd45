#include "expression/routine.h"

#include "expression/operation.h"

#include <algorithm>
#include <array>
#include <limits>

namespace expression {
namespace {

using Value = std::uint32_t; // a slot of the sequence; guards have slots after all others
constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();
constexpr unsigned noRegister = Routine::registers;

struct Item {
    Step::Kind kind;
    Op op;
    std::int32_t decision;
    Value result;
    std::array<Value, 3> arguments;
    unsigned count;                       // of arguments
    std::array<std::uint32_t, 3> nextUse; // of each argument after this item
    std::uint32_t firstUse;               // of the result
};

bool isLibraryFunction(Op op) {
    switch (op) {
    case Op::sin:
    case Op::cos:
    case Op::tan:
    case Op::asin:
    case Op::acos:
    case Op::atan:
    case Op::sinh:
    case Op::cosh:
    case Op::tanh:
    case Op::exp:
    case Op::log:
    case Op::log10:
    case Op::power:
    case Op::atan2:
    case Op::hypot:
        return true;
    default:
        return false;
    }
}

bool isRounding(Op op) { return op == Op::floor || op == Op::ceil; }

bool isCall(const Item& item, Ability ability) {
    if (item.kind == Step::Kind::operate)
        return isLibraryFunction(item.op) || (isRounding(item.op) && !ability.rounds);
    return !ability.branches || isRounding(item.op);
}

// Plain arithmetic reads its last operand from memory as well as from a register.
bool readsMemory(const Item& item, unsigned argument) {
    if (item.kind == Step::Kind::guard)
        return argument == 1;
    if (item.kind != Step::Kind::operate)
        return false;
    switch (item.op) {
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
        return argument == 1;
    case Op::sqrt:
        return true;
    default:
        return false;
    }
}

// The items of a routine, in order, without those that nothing needs; each knows when its values
// are used next.
class Program {
public:
    enum class Order { asGiven, byOutput };
    Program(const Sequence& sequence, Purpose purpose, Order order) {
        Value next = sequence.slots();
        for (const Sequence::Instruction& i : sequence.instructions) {
            const bool decides = i.decision >= 0;
            const auto count = static_cast<unsigned>(argumentCount(i.op));
            if (purpose == Purpose::guards && decides) {
                outputs.push_back(next);
                items.push_back(
                    {Step::Kind::guard, i.op, i.decision, next++, {i.a, i.b, i.c}, count, {}, {}});
            }
            const bool frozen = decides && purpose != Purpose::values;
            items.push_back({frozen ? Step::Kind::frozen : Step::Kind::operate,
                             i.op,
                             i.decision,
                             i.result,
                             {i.a, i.b, i.c},
                             count,
                             {},
                             {}});
        }
        values = next;
        if (purpose != Purpose::guards)
            outputs = sequence.outputs;
        keepNeeded();
        if (order == Order::byOutput)
            reorder();
        findUses();
    }

    std::vector<Item> items;
    std::vector<Value> outputs; // the value of each
    std::vector<std::uint32_t> firstUse;
    std::uint32_t values = 0;

private:
    void keepNeeded() {
        std::vector<bool> needed(values);
        for (const Value v : outputs)
            needed[v] = true;
        for (auto item = items.rbegin(); item != items.rend(); ++item)
            for (unsigned k = 0; needed[item->result] && k < item->count; ++k)
                needed[item->arguments[k]] = true;
        std::erase_if(items, [&needed](const Item& item) { return !needed[item.result]; });
    }

    // Each output with what it needs and is not there yet, one after the other: values live
    // shortly.
    void reorder() {
        std::vector<std::uint32_t> maker(values,
                                         never); // item of each value; never once it is placed
        for (std::uint32_t i = 0; i < items.size(); ++i)
            maker[items[i].result] = i;
        std::vector<Item> ordered;
        ordered.reserve(items.size());
        std::vector<Value> stack;
        for (const Value output : outputs) {
            stack.push_back(output);
            while (!stack.empty()) {
                const Value v = stack.back();
                if (maker[v] == never) {
                    stack.pop_back();
                    continue;
                }
                const Item& item = items[maker[v]];
                const std::size_t size = stack.size();
                for (unsigned k = item.count; k-- > 0;)
                    if (maker[item.arguments[k]] != never)
                        stack.push_back(item.arguments[k]);
                if (stack.size() > size)
                    continue;
                stack.pop_back();
                ordered.push_back(item);
                maker[v] = never;
            }
        }
        items = std::move(ordered);
    }

    void findUses() {
        std::vector<std::uint32_t> next(values, never);
        auto position = static_cast<std::uint32_t>(items.size());
        for (auto item = items.rbegin(); item != items.rend(); ++item) {
            --position;
            item->firstUse = next[item->result];
            for (unsigned k = 0; k < item->count; ++k)
                item->nextUse[k] = next[item->arguments[k]];
            for (unsigned k = 0; k < item->count; ++k)
                next[item->arguments[k]] = position;
        }
        firstUse = std::move(next);
    }
};

class Planner {
public:
    Planner(const Sequence& sequence, Purpose purpose, Ability ability, Program::Order order)
        : program_(sequence, purpose, order), ability_(ability), reg_(program_.values, noRegister),
          home_(program_.values), nextUse_(program_.firstUse), outputOf_(program_.values, never),
          nextOutput_(program_.outputs.size(), never) {
        for (Value v = 0; v < sequence.inputs; ++v)
            home_[v] = {Place::Kind::input, v};
        for (Value v = 0; v < sequence.constants; ++v)
            home_[sequence.inputs + v] = {Place::Kind::constant, v};
        for (auto k = static_cast<std::uint32_t>(program_.outputs.size()); k-- > 0;) {
            nextOutput_[k] = outputOf_[program_.outputs[k]];
            outputOf_[program_.outputs[k]] = k;
        }
        first_ = sequence.inputs + sequence.constants;
        holds_.fill(never);
    }

    // Given up when it needs more than `most` places for spills.
    Routine run(std::uint32_t most = never) {
        routine_.steps.reserve(2 * program_.items.size());
        for (Value v = 0; v < first_; ++v)
            if (outputOf_[v] != never)
                copyToOutputs(v);
        for (const Item& item : program_.items) {
            add(item);
            if (routine_.spills > most)
                break;
        }
        return std::move(routine_);
    }

private:
    void add(const Item& item) {
        Step step{.kind = item.kind,
                  .op = item.op,
                  .isCall = isCall(item, ability_),
                  .decision = item.decision,
                  .to = {},
                  .a = {},
                  .b = {},
                  .c = {}};
        std::array<Value, 3> arguments = item.arguments;
        std::array<std::uint32_t, 3> nextUse = item.nextUse;
        if (item.kind == Step::Kind::operate && (item.op == Op::add || item.op == Op::multiply) &&
            reg_[arguments[0]] == noRegister && reg_[arguments[1]] != noRegister) {
            std::swap(arguments[0], arguments[1]); // memory comes second
            std::swap(nextUse[0], nextUse[1]);
        }
        pinned_.fill(false);
        Place* const places[] = {&step.a, &step.b, &step.c};
        for (unsigned k = 0; k < item.count; ++k)
            *places[k] = operand(item, step.isCall, k, arguments[k], nextUse[k]);
        for (unsigned k = 0; k < item.count; ++k)
            setNextUse(arguments[k], nextUse[k]);
        if (step.isCall)
            saveAll();
        for (unsigned k = 0; k < item.count; ++k)
            if (nextUse[k] == never)
                release(arguments[k]);
        if (step.isCall)
            forgetRegisters();
        nextUse_[item.result] = item.firstUse;
        pinned_.fill(false);
        const unsigned target = freeRegister();
        take(target, item.result);
        step.to = {Place::Kind::reg, target};
        routine_.hasCalls |= step.isCall;
        routine_.steps.push_back(step);
        freeSpills_.insert(freeSpills_.end(), read_.begin(), read_.end());
        read_.clear();
        storeOutputs(item.result, target);
        if (item.firstUse == never)
            release(item.result);
    }

    // Where an operand is read: loaded when the operation wants it so, or when it pays.
    Place operand(const Item& item, bool call, unsigned k, Value v, std::uint32_t nextUse) {
        const bool mustLoad = !call && !readsMemory(item, k);
        const bool pays = !call && nextUse != never && hasFreeRegister();
        if (reg_[v] == noRegister && (mustLoad || pays))
            load(v);
        if (reg_[v] == noRegister)
            return home_[v];
        pinned_[reg_[v]] = true;
        return {Place::Kind::reg, reg_[v]};
    }

    void load(Value v) {
        const unsigned r = freeRegister();
        routine_.steps.push_back(move(Step::Kind::load, {Place::Kind::reg, r}, home_[v]));
        take(r, v);
    }

    static Step move(Step::Kind kind, Place to, Place from) {
        Step step;
        step.kind = kind;
        step.to = to;
        step.a = from;
        return step;
    }

    [[nodiscard]] bool hasFreeRegister() const {
        return std::ranges::find(holds_, never) != holds_.end();
    }

    unsigned freeRegister() {
        unsigned best = noRegister;
        std::uint32_t furthest = 0;
        for (unsigned r = 0; r < Routine::registers; ++r) {
            if (holds_[r] == never)
                return r;
            if (!pinned_[r] && (best == noRegister || nextUseOfRegister_[r] > furthest)) {
                best = r;
                furthest = nextUseOfRegister_[r];
            }
        }
        save(holds_[best]);
        reg_[holds_[best]] = noRegister;
        holds_[best] = never;
        return best;
    }

    void take(unsigned r, Value v) {
        holds_[r] = v;
        reg_[v] = r;
        nextUseOfRegister_[r] = nextUse_[v];
    }

    void setNextUse(Value v, std::uint32_t next) {
        nextUse_[v] = next;
        if (reg_[v] != noRegister)
            nextUseOfRegister_[reg_[v]] = next;
    }

    // Memory has it.
    void save(Value v) {
        if (home_[v].kind != Place::Kind::none)
            return;
        if (freeSpills_.empty())
            freeSpills_.push_back(routine_.spills++);
        home_[v] = {Place::Kind::spill, freeSpills_.back()};
        freeSpills_.pop_back();
        routine_.steps.push_back(move(Step::Kind::store, home_[v], {Place::Kind::reg, reg_[v]}));
    }

    void saveAll() {
        for (const Value v : holds_)
            if (v != never && nextUse_[v] != never)
                save(v);
    }

    void forgetRegisters() {
        for (Value& v : holds_)
            if (v != never) {
                reg_[v] = noRegister;
                v = never;
            }
    }

    void release(Value v) {
        if (reg_[v] != noRegister)
            holds_[reg_[v]] = never;
        reg_[v] = noRegister;
        if (home_[v].kind == Place::Kind::spill)
            read_.push_back(home_[v].index);
        home_[v] = {};
    }

    void storeOutputs(Value v, unsigned r) {
        for (std::uint32_t k = outputOf_[v]; k != never; k = nextOutput_[k]) {
            home_[v] = {Place::Kind::output, k};
            routine_.steps.push_back(move(Step::Kind::store, home_[v], {Place::Kind::reg, r}));
        }
    }

    // An output that is an input or a constant.
    void copyToOutputs(Value v) {
        const Place home = home_[v];
        const unsigned r = freeRegister();
        routine_.steps.push_back(move(Step::Kind::load, {Place::Kind::reg, r}, home));
        storeOutputs(v, r);
        home_[v] = home;
    }

    Program program_;
    Ability ability_;
    Routine routine_;
    std::vector<unsigned> reg_; // of each value
    std::vector<Place> home_;   // in memory, if it is there
    std::vector<std::uint32_t> nextUse_;
    std::vector<std::uint32_t> outputOf_, nextOutput_; // lists of the outputs that a value is
    std::vector<std::uint32_t> freeSpills_, read_;     // read: by the step that is being made
    std::array<Value, Routine::registers> holds_;
    std::array<std::uint32_t, Routine::registers> nextUseOfRegister_{};
    std::array<bool, Routine::registers> pinned_{};
    Value first_ = 0; // result
};

std::string named(Place place) {
    static constexpr const char* names[] = {"", "x", "in", "const", "out", "spill"};
    return ' ' + std::string(names[static_cast<int>(place.kind)]) + std::to_string(place.index);
}

} // namespace

Routine makeRoutine(const Sequence& sequence, Purpose purpose, Ability ability) {
    // The given order has more that does not wait for each other; the other needs less memory.
    constexpr std::uint32_t few = 64, part = 8; // of the operations
    const auto operations = static_cast<std::uint32_t>(sequence.instructions.size());
    const std::uint32_t many = std::max(few, operations / part);
    Routine routine = Planner(sequence, purpose, ability, Program::Order::asGiven).run(many);
    if (routine.spills > many)
        routine = Planner(sequence, purpose, ability, Program::Order::byOutput).run();
    return routine;
}

std::string print(const Step& s) {
    std::string text = named(s.to).substr(1) + " =";
    if (s.kind == Step::Kind::guard)
        text += " guard";
    if (s.kind != Step::Kind::load && s.kind != Step::Kind::store)
        text += ' ' + std::string(nameOf(s.op));
    for (const Place place : {s.a, s.b, s.c})
        if (place.kind != Place::Kind::none)
            text += named(place);
    if (s.kind == Step::Kind::frozen || s.kind == Step::Kind::guard)
        text += "  [decision " + std::to_string(s.decision) + ']';
    return text + (s.isCall ? "  (call)" : "");
}

std::string Routine::print() const {
    std::string text;
    for (const Step& step : steps)
        text += expression::print(step) + '\n';
    return text;
}

} // namespace expression
