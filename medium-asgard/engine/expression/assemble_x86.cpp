#include "expression/assemble.h"

#include "expression/operation.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <sstream>

#include <asmjit/x86.h>

namespace expression {
namespace {

namespace x86 = asmjit::x86;
using asmjit::Label;
namespace Inst = x86::Inst;
using x86::Vec;

// Asked of the compiler's runtime, which knows; asmjit would put all its questions to the
// processor.
bool hasAvx() { return __builtin_cpu_supports("avx") != 0; }

// An instruction on one number and on a vector, without and with three operands.
struct Forms {
    asmjit::InstId one, many, oneOfThree, manyOfThree;
};
constexpr Forms adds{Inst::kIdAddsd, Inst::kIdAddpd, Inst::kIdVaddsd, Inst::kIdVaddpd};
constexpr Forms subtracts{Inst::kIdSubsd, Inst::kIdSubpd, Inst::kIdVsubsd, Inst::kIdVsubpd};
constexpr Forms multiplies{Inst::kIdMulsd, Inst::kIdMulpd, Inst::kIdVmulsd, Inst::kIdVmulpd};
constexpr Forms divides{Inst::kIdDivsd, Inst::kIdDivpd, Inst::kIdVdivsd, Inst::kIdVdivpd};
constexpr Forms compares{Inst::kIdCmpsd, Inst::kIdCmppd, Inst::kIdVcmpsd, Inst::kIdVcmppd};
constexpr Forms ands{Inst::kIdAndpd, Inst::kIdAndpd, Inst::kIdVandpd, Inst::kIdVandpd};
constexpr Forms andNots{Inst::kIdAndnpd, Inst::kIdAndnpd, Inst::kIdVandnpd, Inst::kIdVandnpd};
constexpr Forms ors{Inst::kIdOrpd, Inst::kIdOrpd, Inst::kIdVorpd, Inst::kIdVorpd};
constexpr Forms xors{Inst::kIdXorpd, Inst::kIdXorpd, Inst::kIdVxorpd, Inst::kIdVxorpd};

// Of comparisons.
enum Relation : std::uint8_t { equals = 0, below = 1, atMost = 2, unordered = 3, differs = 4 };

// The functions that generated code calls.
using One = double (*)(double);
using Two = double (*)(double, double);
const void* functionOf(Op op) {
    const auto one = [](One f) { return std::bit_cast<const void*>(f); };
    const auto two = [](Two f) { return std::bit_cast<const void*>(f); };
    switch (op) {
    case Op::sin:
        return one(std::sin);
    case Op::cos:
        return one(std::cos);
    case Op::tan:
        return one(std::tan);
    case Op::asin:
        return one(std::asin);
    case Op::acos:
        return one(std::acos);
    case Op::atan:
        return one(std::atan);
    case Op::sinh:
        return one(std::sinh);
    case Op::cosh:
        return one(std::cosh);
    case Op::tanh:
        return one(std::tanh);
    case Op::exp:
        return one(std::exp);
    case Op::log:
        return one(std::log);
    case Op::log10:
        return one(std::log10);
    case Op::floor:
        return one(std::floor);
    case Op::ceil:
        return one(std::ceil);
    case Op::atan2:
        return two(std::atan2);
    case Op::hypot:
        return two(std::hypot);
    default:
        return two(powerOf);
    }
}

// onBranch and guardOf, with the numbers first: in xmm0 and xmm1, edi and rsi.
double frozenValue(double a, double b, std::uint32_t op, Decision taken) {
    return onBranch(static_cast<Op>(op), a, b, taken);
}
double guardValue(double a, double b, std::uint32_t op, Decision taken) {
    return guardOf(static_cast<Op>(op), a, b, taken);
}

class Assembler {
public:
    Assembler(const Routine& routine, Target target)
        : routine_(routine), lanes_(target.lanes), avx_(target.avx) {
        code_.init(asmjit::Environment::host());
        code_.attach(&a_);
        pool_ = a_.newLabel();
    }

    std::vector<std::byte> run() {
        begin();
        for (const Step& step : routine_.steps)
            add(step);
        end();
        embedPool();
        if (code_.flatten() != asmjit::kErrorOk || failed_)
            return {};
        const asmjit::CodeBuffer& text = code_.textSection()->buffer();
        std::vector<std::byte> bytes(text.size());
        std::memcpy(bytes.data(), text.data(), text.size());
        return bytes;
    }

    std::string list() {
        asmjit::StringLogger log;
        code_.setLogger(&log);
        begin();
        std::string text = instructionsOf(log, "");
        for (const Step& step : routine_.steps) {
            add(step);
            text += "; " + print(step) + '\n' + instructionsOf(log, calledBy(step));
        }
        end();
        text += "; end\n" + instructionsOf(log, "");
        code_.resetLogger();
        return failed_ ? std::string() : text;
    }

private:
    // What was logged, a line each. The address of a function that is called is another in each
    // process: its name says more.
    static std::string instructionsOf(asmjit::StringLogger& log, const std::string& called) {
        std::string text;
        std::istringstream lines(std::string(log.data(), log.dataSize()));
        std::size_t last = 0;
        for (std::string line; std::getline(lines, line);) {
            const std::size_t word = std::min(line.find_first_not_of(' '), line.size());
            if (line.compare(word, 5, "call ") == 0)
                text.replace(last, std::string::npos, "    mov rax, " + called + '\n');
            last = text.size();
            text += "    " + line.substr(word) + '\n';
        }
        log.clear();
        return text;
    }
    static std::string calledBy(const Step& step) {
        return step.kind == Step::Kind::frozen  ? "frozenValue"
               : step.kind == Step::Kind::guard ? "guardValue"
               : step.op == Op::power           ? "pow"
                                                : std::string(nameOf(step.op));
    }

    // Arguments stay where they came, unless calls would lose them.
    void begin() {
        if (!routine_.hasCalls)
            return;
        const x86::Gp kept[] = {x86::rbx, x86::rbp, x86::r12, x86::r13, x86::r14};
        const x86::Gp given[] = {x86::rdi, x86::rsi, x86::rdx, x86::rcx, x86::r8};
        for (const x86::Gp& r : kept)
            emit(Inst::kIdPush, r);
        for (std::size_t i = 0; i < std::size(kept); ++i)
            emit(Inst::kIdMov, kept[i], given[i]);
        in_ = kept[0];
        out_ = kept[1];
        constants_ = kept[2];
        decisions_ = kept[3];
        scratch_ = kept[4];
    }

    void end() {
        if (avx_ && lanes_ > 1)
            emit(Inst::kIdVzeroupper);
        if (routine_.hasCalls)
            for (const x86::Gp& r : {x86::r14, x86::r13, x86::r12, x86::rbp, x86::rbx})
                emit(Inst::kIdPop, r);
        emit(Inst::kIdRet);
    }
    void embedPool() {
        a_.align(asmjit::AlignMode::kData, 32);
        a_.bind(pool_);
        constexpr std::uint64_t sign = std::uint64_t{1} << 63;
        for (const std::uint64_t entry : {sign, ~sign, std::bit_cast<std::uint64_t>(1.0),
                                          std::bit_cast<std::uint64_t>(-1.0), std::uint64_t{0}})
            for (int lane = 0; lane < 4; ++lane)
                a_.embedUInt64(entry);
    }
    enum Constant : std::int32_t {
        signBit = 0,
        allButSign = 32,
        one = 64,
        minusOne = 96,
        zero = 128
    };
    [[nodiscard]] x86::Mem pool(Constant constant) const { return x86::ptr(pool_, constant); }

    template <class... Operands> void emit(asmjit::InstId id, const Operands&... operands) {
        failed_ |= a_.emit(id, operands...) != asmjit::kErrorOk;
    }
    void emit(const Forms& forms, const Vec& to, const Vec& a, const asmjit::Operand& b) {
        if (avx_)
            return emit(lanes_ > 1 ? forms.manyOfThree : forms.oneOfThree, to, a, b);
        copy(to, a);
        emit(lanes_ > 1 ? forms.many : forms.one, to, b);
    }
    void compare(const Vec& to, const Vec& a, const asmjit::Operand& b, Relation relation) {
        if (avx_)
            return emit(lanes_ > 1 ? compares.manyOfThree : compares.oneOfThree, to, a, b,
                        asmjit::imm(relation));
        copy(to, a);
        emit(lanes_ > 1 ? compares.many : compares.one, to, b, asmjit::imm(relation));
    }
    void copy(const Vec& to, const Vec& from) {
        if (to.id() != from.id())
            emit(avx_ ? Inst::kIdVmovapd : Inst::kIdMovapd, to, from);
    }
    void load(const Vec& to, const x86::Mem& from) {
        const bool many = lanes_ > 1;
        emit(avx_   ? many ? Inst::kIdVmovupd : Inst::kIdVmovsd
             : many ? Inst::kIdMovupd
                    : Inst::kIdMovsd,
             to, from);
    }
    void store(const x86::Mem& to, const Vec& from) {
        const bool many = lanes_ > 1;
        emit(avx_   ? many ? Inst::kIdVmovupd : Inst::kIdVmovsd
             : many ? Inst::kIdMovupd
                    : Inst::kIdMovsd,
             to, from);
    }

    [[nodiscard]] Vec reg(unsigned r) const {
        return avx_ && lanes_ > 1 ? Vec(x86::ymm(r)) : Vec(x86::xmm(r));
    }
    [[nodiscard]] Vec reg(Place place) const { return reg(place.index); }
    [[nodiscard]] x86::Mem memory(Place place, unsigned lane = 0) const {
        const x86::Gp base = place.kind == Place::Kind::input      ? in_
                             : place.kind == Place::Kind::output   ? out_
                             : place.kind == Place::Kind::constant ? constants_
                                                                   : scratch_;
        return x86::ptr(base, static_cast<std::int32_t>(8 * (place.index * lanes_ + lane)));
    }
    [[nodiscard]] asmjit::Operand operand(Place place) const {
        return place.kind == Place::Kind::reg ? asmjit::Operand(reg(place))
                                              : asmjit::Operand(memory(place));
    }

    void add(const Step& step) {
        if (step.kind == Step::Kind::load)
            load(reg(step.to), memory(step.a));
        else if (step.kind == Step::Kind::store)
            store(memory(step.to), reg(step.a));
        else if (step.isCall && lanes_ > 1)
            callLanes(step);
        else if (step.isCall)
            callOne(step);
        else if (step.kind == Step::Kind::operate)
            operate(step);
        else if (step.kind == Step::Kind::frozen)
            frozen(step);
        else
            guard(step);
    }

    // to = a op b where `to` may be either of them.
    void arithmetic(const Forms& forms, const Step& step) {
        const Vec to = reg(step.to), a = reg(step.a);
        const bool isSecond = step.b == step.to && step.a != step.to;
        if (avx_ || !isSecond)
            return emit(forms, to, a, operand(step.b));
        emit(forms, t0(), a, reg(step.b));
        copy(to, t0());
    }
    [[nodiscard]] Vec t0() const { return reg(14); }
    [[nodiscard]] Vec t1() const { return reg(15); }

    void operate(const Step& step) {
        switch (step.op) {
        case Op::add:
            return arithmetic(adds, step);
        case Op::subtract:
            return arithmetic(subtracts, step);
        case Op::multiply:
            return arithmetic(multiplies, step);
        case Op::divide:
            return arithmetic(divides, step);
        case Op::negate:
            return emit(xors, reg(step.to), reg(step.a), pool(signBit));
        case Op::sqrt:
            return squareRoot(step);
        case Op::floor:
        case Op::ceil:
            return round(step);
        default:
            select(step);
            copy(reg(step.to), t0());
        }
    }

    void squareRoot(const Step& step) {
        const Vec to = reg(step.to);
        if (lanes_ > 1)
            return emit(avx_ ? Inst::kIdVsqrtpd : Inst::kIdSqrtpd, to, operand(step.a));
        if (avx_)
            return emit(Inst::kIdVsqrtsd, to, step.a.kind == Place::Kind::reg ? reg(step.a) : to,
                        operand(step.a));
        emit(Inst::kIdSqrtsd, to, operand(step.a));
    }

    void round(const Step& step) {
        const auto mode = asmjit::imm(step.op == Op::floor ? 9 : 10); // down, up; quietly
        if (lanes_ > 1)
            emit(Inst::kIdVroundpd, reg(step.to), reg(step.a), mode);
        else
            emit(Inst::kIdVroundsd, reg(step.to), reg(step.a), reg(step.a), mode);
    }

    // t0 = what is selected by comparing; reads all operands before `to` is written.
    void select(const Step& step) {
        const Vec a = reg(step.a), b = reg(step.b);
        switch (step.op) {
        case Op::abs:
            return emit(ands, t0(), a, pool(allButSign));
        case Op::sign:
            return sign(a);
        case Op::min:
            return extreme(a, b, a, b);
        case Op::max:
            return extreme(b, a, a, b);
        case Op::less:
            return truth(a, b, below);
        case Op::lessEqual:
            return truth(a, b, atMost);
        case Op::equal:
            return truth(a, b, equals);
        case Op::notEqual:
            return truth(a, b, differs);
        case Op::logicalNot:
            compare(t0(), a, pool(zero), equals);
            return emit(ands, t0(), t0(), pool(one));
        case Op::logicalAnd:
        case Op::logicalOr:
            compare(t0(), a, pool(zero), differs);
            compare(t1(), b, pool(zero), differs);
            emit(step.op == Op::logicalAnd ? ands : ors, t0(), t0(), t1());
            return emit(ands, t0(), t0(), pool(one));
        case Op::select: // the mask chooses b, its complement c
            compare(t0(), a, pool(zero), differs);
            emit(ands, t1(), t0(), b);
            emit(andNots, t0(), t0(), reg(step.c));
            return emit(ors, t0(), t0(), t1());
        default:
            failed_ = true;
        }
    }

    void truth(const Vec& a, const Vec& b, Relation relation) {
        compare(t0(), a, b, relation);
        emit(ands, t0(), t0(), pool(one));
    }

    // 1, -1, 0, or the NaN that it is.
    void sign(const Vec& a) {
        load(t1(), pool(zero));
        compare(t0(), t1(), a, below);
        emit(ands, t0(), t0(), pool(one));
        compare(t1(), a, pool(zero), below);
        emit(ands, t1(), t1(), pool(minusOne));
        emit(ors, t0(), t0(), t1());
        compare(t1(), a, a, unordered);
        emit(ands, t1(), t1(), a);
        emit(ors, t0(), t0(), t1());
    }

    // a where p <= q, b where q < p; their sum, a NaN, where neither is.
    void extreme(const Vec& p, const Vec& q, const Vec& a, const Vec& b) {
        compare(t0(), p, q, atMost);
        emit(ands, t0(), t0(), a);
        compare(t1(), q, p, below);
        emit(ands, t1(), t1(), b);
        emit(ors, t0(), t0(), t1());
        compare(t1(), a, b, unordered);
        emit(ors, t0(), t0(), t1()); // all bits of a mask set: a NaN
    }

    // The value on the branch given; floor, ceil and lanes are calls. Nothing but t0 is written
    // until the end, and the registers of the operands stay as they are.
    void frozen(const Step& step) {
        const Label byValues = a_.newLabel(), done = a_.newLabel();
        emit(Inst::kIdMov, x86::rax, decision(step.decision));
        emit(Inst::kIdCmp, x86::rax, asmjit::imm(1));
        emit(Inst::kIdJo, byValues); // the least of all integers is noBranch
        if (step.op == Op::abs || step.op == Op::min || step.op == Op::max)
            chosen(step, byValues, done);
        else
            decided(step.op);
        emit(Inst::kIdJmp, done);
        a_.bind(byValues);
        select(step);
        a_.bind(done);
        copy(reg(step.to), t0());
    }
    [[nodiscard]] x86::Mem decision(std::int32_t index) const {
        return x86::ptr(decisions_, 8 * index, 8);
    }

    // One of two values, by the sign of rax, which has been compared with 1; of 0 by the values.
    void chosen(const Step& step, const Label& byValues, const Label& done) {
        const Label above = a_.newLabel();
        const Vec a = reg(step.a);
        emit(Inst::kIdJge, above);
        emit(Inst::kIdTest, x86::rax, x86::rax);
        emit(Inst::kIdJz, byValues);
        if (step.op == Op::abs)
            emit(xors, t0(), a, pool(signBit));
        else
            copy(t0(), step.op == Op::min ? a : reg(step.b));
        emit(Inst::kIdJmp, done);
        a_.bind(above);
        copy(t0(), step.op == Op::min ? reg(step.b) : a);
    }

    // A number that the branch alone says.
    void decided(Op op) {
        const asmjit::InstId set = op == Op::less        ? Inst::kIdSetl
                                   : op == Op::lessEqual ? Inst::kIdSetle
                                   : op == Op::equal     ? Inst::kIdSete
                                                         : Inst::kIdSetne;
        if (op != Op::sign) {
            emit(Inst::kIdTest, x86::rax, x86::rax);
            emit(set, x86::al);
            emit(Inst::kIdMovzx, x86::eax, x86::al);
        }
        load(t0(), pool(zero));
        if (avx_)
            emit(Inst::kIdVcvtsi2sd, t0(), t0(), x86::rax);
        else
            emit(Inst::kIdCvtsi2sd, t0(), x86::rax);
    }

    // a, or a - b; 1 where there is no branch.
    void guard(const Step& step) {
        const Label done = a_.newLabel();
        emit(Inst::kIdMov, x86::rax, decision(step.decision));
        if (step.b.kind == Place::Kind::none)
            copy(t0(), reg(step.a));
        else
            emit(subtracts, t0(), reg(step.a), operand(step.b));
        emit(Inst::kIdCmp, x86::rax, asmjit::imm(1));
        emit(Inst::kIdJno, done);
        load(t0(), pool(one));
        a_.bind(done);
        copy(reg(step.to), t0());
    }

    void call(const Step& step, unsigned lane) {
        const void* function = functionOf(step.op);
        if (step.kind != Step::Kind::operate) {
            function = std::bit_cast<const void*>(step.kind == Step::Kind::frozen ? &frozenValue
                                                                                  : &guardValue);
            emit(Inst::kIdMov, x86::edi, asmjit::imm(static_cast<std::uint32_t>(step.op)));
            emit(Inst::kIdMov, x86::rsi,
                 decision(step.decision * static_cast<std::int32_t>(lanes_) +
                          static_cast<std::int32_t>(lane)));
        }
        emit(Inst::kIdMov, x86::rax, asmjit::imm(std::bit_cast<std::uintptr_t>(function)));
        emit(Inst::kIdCall, x86::rax);
    }

    void callOne(const Step& step) {
        const bool two = step.b.kind != Place::Kind::none;
        const bool crossed = step.b == Place{Place::Kind::reg, 0};
        if (crossed)
            copy(t0(), reg(0));
        argument(0, step.a);
        if (crossed)
            copy(reg(1), t0());
        else if (two)
            argument(1, step.b);
        call(step, 0);
        copy(reg(step.to), reg(0));
    }
    void argument(unsigned r, Place from) {
        if (from.kind == Place::Kind::reg)
            copy(reg(r), reg(from));
        else
            load(reg(r), memory(from));
    }

    // Arguments that are in registers go to memory; each lane is called with its own.
    void callLanes(const Step& step) {
        const Place a = inMemory(step.a, 0), b = inMemory(step.b, 1);
        const Place result{Place::Kind::spill, routine_.spills + 2};
        const auto move = avx_ ? Inst::kIdVmovsd : Inst::kIdMovsd;
        if (avx_)
            emit(Inst::kIdVzeroupper);
        for (unsigned lane = 0; lane < lanes_; ++lane) {
            emit(move, x86::xmm0, memory(a, lane));
            if (b.kind != Place::Kind::none)
                emit(move, x86::xmm1, memory(b, lane));
            call(step, lane);
            emit(move, memory(result, lane), x86::xmm0);
        }
        load(reg(step.to), memory(result));
    }
    Place inMemory(Place from, std::uint32_t which) {
        if (from.kind != Place::Kind::reg)
            return from;
        const Place to{Place::Kind::spill, routine_.spills + which};
        store(memory(to), reg(from));
        return to;
    }

    const Routine& routine_;
    unsigned lanes_;
    bool avx_, failed_ = false;
    asmjit::CodeHolder code_;
    x86::Assembler a_;
    Label pool_;
    x86::Gp in_ = x86::rdi, out_ = x86::rsi, constants_ = x86::rdx, decisions_ = x86::rcx,
            scratch_ = x86::r8;
};

} // namespace

Target oneAtATime() { return {1, hasAvx()}; }
Target manyAtOnce() { return {hasAvx() ? 4u : 2u, hasAvx()}; }

Ability abilityOf(Target target) { return {.rounds = target.avx, .branches = target.lanes == 1}; }

std::vector<std::byte> assemble(const Routine& routine, Target target) {
    return Assembler(routine, target).run();
}

std::string listing(const Routine& routine, Target target) {
    return Assembler(routine, target).list();
}

std::size_t scratchOf(const Routine& routine, Target target) {
    return (routine.spills + (target.lanes > 1 ? 3 : 0)) * std::size_t{target.lanes};
}

} // namespace expression
