#include "ipc/wire.h"

#include "ipc/framing.h"
#include "ipc/json_fields.h"
#include "text/characters.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace ipc {
namespace {

using testing::HasSubstr;

const AwaitedCall nothingAwaited = [](Integer) { return std::nullopt; };

std::string bodyOf(const std::string& method, const std::string& params, bool request = true) {
    return R"({"jsonrpc":"2.0",)" + std::string(request ? R"("id":7,)" : "") + R"("method":")" +
           method + R"(","params":)" + params + "}";
}

// The result of reading it, in words.
template <class Call> std::string described(const Decoded<Call>& decoded) {
    if (auto* v = std::get_if<Violation>(&decoded))
        return "violation: " + v->sentence;
    if (auto* u = std::get_if<Unanswerable>(&decoded))
        return "refused " + std::to_string(u->error.code) + ": " + u->error.message;
    if (std::holds_alternative<Ignored>(decoded))
        return "ignored";
    const auto name = [](const auto& call) { return std::string(call.method); };
    if (auto* asked = std::get_if<Asked<Call>>(&decoded))
        return "asked " + std::visit(name, asked->call);
    if (auto* told = std::get_if<Told<Call>>(&decoded))
        return "told " + std::visit(name, told->call);
    return "answered";
}

std::string forMedium(const std::string& body) {
    return described(decodeForMedium(body, nothingAwaited));
}

template <class T> T sentToMedium(const T& call) {
    if constexpr (IsRequest<T>) {
        auto decoded = decodeForMedium(encodeRequest(5, ToMedium(call)), nothingAwaited);
        EXPECT_EQ(std::get<Asked<ToMedium>>(decoded).id, Id(Integer{5}));
        return std::get<T>(std::get<Asked<ToMedium>>(decoded).call);
    } else {
        auto decoded = decodeForMedium(encodeNotification(ToMedium(call)), nothingAwaited);
        return std::get<T>(std::get<Told<ToMedium>>(decoded).call);
    }
}

// Calls f with a default value of every alternative.
template <class Variant, class F, std::size_t I = 0> void forEachCall(F f) {
    if constexpr (I < std::variant_size_v<Variant>) {
        f(std::variant_alternative_t<I, Variant>{});
        forEachCall<Variant, F, I + 1>(f);
    }
}

// Defaults that the ranges of the protocol refuse.
template <class T> T smallest() {
    T call;
    if constexpr (requires {
                      call.width;
                      call.height;
                  })
        call.width = call.height = 1;
    if constexpr (requires { call.availableWidth; })
        call.availableWidth = 1;
    return call;
}

TEST(Wire, EveryCallOfBothDirectionsSurvivesTheWire) {
    int calls = 0;
    forEachCall<ToMedium>([&](auto call) {
        using T = decltype(call);
        const ToMedium message = smallest<T>();
        const std::string body =
            IsRequest<T> ? encodeRequest(1, message) : encodeNotification(message);
        const std::string kind = IsRequest<T> ? "asked " : "told ";
        EXPECT_EQ(forMedium(body), kind + T::method) << body;
        ++calls;
    });
    forEachCall<ToHost>([&](auto call) {
        using T = decltype(call);
        const ToHost message = smallest<T>();
        const std::string body =
            IsRequest<T> ? encodeRequest(1, message) : encodeNotification(message);
        const std::string kind = IsRequest<T> ? "asked " : "told ";
        EXPECT_EQ(described(decodeForHost(body, nothingAwaited)), kind + T::method) << body;
        ++calls;
    });
    EXPECT_EQ(calls, 31 + 18);
}

TEST(Wire, FieldsArriveAsTheyWereSent) {
    Initialize initialize;
    initialize.oldest = 1;
    initialize.newest = 3;
    initialize.documentClass = "ANIMATION";
    initialize.mode = Mode::batch;
    initialize.frames = SharedMemory{5, 1 << 30};
    const Initialize i = sentToMedium(initialize);
    EXPECT_EQ(i.newest, 3);
    EXPECT_EQ(i.mode, Mode::batch);
    EXPECT_EQ(i.frames->bytes, 1 << 30);

    const std::string text("body \xc3\xa9 {\n\t\"\\}\x01\x00z", 18);
    EXPECT_EQ(sentToMedium(SubdocumentLoad{text, 4}).text, text);
    EXPECT_EQ(sentToMedium(SubdocumentEdit{5, {{1, 2, "a"}, {4, 4, ""}}, "Typing"}).edits,
              (text::Edits{{{1, 2}, "a"}, {{4, 4}, ""}}));

    EXPECT_EQ(sentToMedium(SubdocumentLoad{text, 4, "memo.ens"}).title, "memo.ens");
    RenditionCreate create;
    create.width = create.height = 7;
    create.state = "as it was";
    EXPECT_EQ(sentToMedium(create).state, "as it was");
    EXPECT_EQ(sentToMedium(create).height, 7);

    RenditionInput input;
    input.type = InputType::wheel;
    input.buttons = {Button::left, Button::right};
    input.modifiers = {Modifier::control};
    input.dy = -0.25;
    const RenditionInput in = sentToMedium(input);
    EXPECT_EQ(in.type, InputType::wheel);
    EXPECT_EQ(in.buttons, input.buttons);
    EXPECT_EQ(in.modifiers, input.modifiers);
    EXPECT_EQ(in.dy, -0.25);
    EXPECT_EQ(sentToMedium(TimeSeek{1.0 / 3}).time, 1.0 / 3);
}

TEST(Wire, BytesThatAreNotUtf8BecomeQuestionMarksOfTheSameLength) {
    const std::pair<std::string, std::string> cases[] = {
        {"plain", "plain"},
        {"\xc3\xa9\xe2\x82\xac\xf0\x9f\x8e\x88", "\xc3\xa9\xe2\x82\xac\xf0\x9f\x8e\x88"},
        {"a\xff"
         "b",
         "a?b"},
        {"\xc3", "?"},
        {"\xe2\x82", "??"},
        {"\xc0\xaf", "??"},
        {"\xed\xa0\x80", "???"},
        {"\xf5\x80\x80\x80", "????"},
        {"\xe0\x80\x80x", "???x"},
        {"\xf4\x90\x80\x80", "????"},
    };
    for (const auto& [given, expected] : cases) {
        EXPECT_EQ(text::asUtf8(given), expected);
        EXPECT_EQ(sentToMedium(SubdocumentLoad{given, 1}).text, expected);
    }
}

TEST(Wire, WhatIsWrongIsNamed) {
    const std::pair<std::string, std::string> cases[] = {
        {bodyOf("no/such", "{}"), "refused -32601: no method \"no/such\""},
        {bodyOf("no/such", "{}", false), "ignored"},
        {bodyOf("rendition/frame", "{}"), "refused -32601: no method \"rendition/frame\""},
        {bodyOf("ping", "[]"), "refused -32602: ping must be an object"},
        {bodyOf("ping", R"({"unknown":[1,{}]})"), "asked ping"},
        {bodyOf("time/seek", "{}"), "refused -32602: time/seek.time is missing"},
        {bodyOf("time/seek", R"({"time":"1"})"), "refused -32602: time/seek.time must be a number"},
        {bodyOf("time/seek", R"({"time":null})"),
         "refused -32602: time/seek.time must be a number"},
        {bodyOf("time/rate", R"({"rate":0})"), "time/rate.rate must lie in 1e-06 to 1000000.0"},
        {bodyOf("rendition/destroy", R"({"rendition":1.5})"), "rendition must be a whole number"},
        {bodyOf("rendition/destroy", R"({"rendition":-1})"), "rendition must not be negative"},
        {bodyOf("rendition/destroy", R"({"rendition":1e300})"), "rendition is out of range"},
        {bodyOf("rendition/destroy", R"({"rendition":3.0})"), "asked rendition/destroy"},
        {bodyOf("initialize", R"({"protocol":[1],"class":"A","mode":"play","frames":null})"),
         "initialize.protocol must be two numbers"},
        {bodyOf("initialize", R"({"protocol":[1,1],"class":"A","mode":"loud","frames":null})"),
         "initialize.mode must be one of play, edit, batch"},
        {bodyOf("initialize", R"({"protocol":[1,1],"class":"A","mode":"play","frames":{"fd":3}})"),
         "initialize.frames.bytes is missing"},
        {bodyOf("subdocument/edit",
                R"({"revision":1,"edits":[{"from":0,"to":1,"text":""},{"from":-1}]})"),
         "subdocument/edit.edits[1].from must not be negative"},
        {bodyOf("rendition/input", R"({"rendition":1,"type":"press","buttons":["left",3]})", false),
         "violation: rendition/input.buttons[1] must be one of none, left"},
        {bodyOf("presentation/size", R"({"presentation":"p","available":7})"),
         "presentation/size.available must be an object"},
        {bodyOf("ping", "{}", false), "violation: ping is a request and came without an id"},
        {bodyOf("rendition/show", R"({"rendition":1})"),
         "refused -32600: rendition/show is a notification"},
        {"[]", "violation: a message that is not a JSON-RPC 2.0 object"},
        {"3", "violation"},
        {"{", "violation: a message that is not JSON"},
        {"{\"jsonrpc\":\"2.0\"}", "violation: a message without method"},
        {"{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":\"ping\"}", "violation: a request whose id"},
        {"{\"jsonrpc\":\"2.0\",\"id\":3,\"result\":{}}",
         "violation: an answer to a request that was not made"},
        {"{\"jsonrpc\":\"2.0\",\"id\":null,\"error\":{\"code\":-32700,\"message\":\"eh\"}}",
         "violation: the other side could not read a message: eh"},
        {"{\"jsonrpc\":\"2.0\",\"id\":3,\"error\":7}", "violation: an error that has no code"},
        {"{\"jsonrpc\":\"2.0\",\"method\":\"\xff\"}", "violation: a message that is not JSON"},
        {std::string(40, '[') + std::string(40, ']'), "violation: a message that nests too deeply"},
        {"[" + std::string(200'000, ',') + "]", "violation: a message of more than 100,000 values"},
        {R"({"jsonrpc":"2.0","id":"abc","method":"ping"})", "asked ping"},
    };
    for (const auto& [body, expected] : cases)
        EXPECT_THAT(forMedium(body), HasSubstr(expected)) << body.substr(0, 200);
}

TEST(Wire, AnswersAreReadByTheRequestThatTheyAnswer) {
    const auto asPresentationList = [](Integer) { return ToMedium(PresentationList{}).index(); };
    const std::string body = encodeAnswer(Id(Integer{9}), Presentations{{{"picture", "Picture"}}});
    EXPECT_THAT(body, HasSubstr(R"("result":[{)"));
    const auto decoded = decodeForHost(body, asPresentationList);
    const auto& answered = std::get<Answered>(decoded);
    EXPECT_EQ(answered.id, 9);
    EXPECT_EQ(std::get<Presentations>(std::get<AnyResult>(answered.outcome)).items[0].label,
              "Picture");

    const auto asInitialize = [](Integer) { return ToMedium(Initialize{}).index(); };
    EXPECT_THAT(described(decodeForHost(body, asInitialize)),
                "violation: the answer to initialize must be an object");
    const auto refused =
        decodeForHost(encodeError(Id(Integer{9}), {ErrorCode::staleBase, "old"}), asInitialize);
    EXPECT_EQ(std::get<Error>(std::get<Answered>(refused).outcome).code, -32002);
}

TEST(Wire, UndefinedValuesAreNull) {
    const std::string body = encodeAnswer(Id(Integer{1}), Values{{1.5, std::nan(""), INFINITY}});
    EXPECT_THAT(body, HasSubstr("[1.5,null,null]"));
    const auto decoded = decodeForHost(body, [](Integer) { return ToMedium(ValueRead{}).index(); });
    const Values values =
        std::get<Values>(std::get<AnyResult>(std::get<Answered>(decoded).outcome));
    EXPECT_EQ(values.values[0], 1.5);
    EXPECT_TRUE(std::isnan(values.values[1]));
}

TEST(Wire, FlippedBitsAndCutsNeverDoMoreThanRefuse) {
    RenditionCreate create;
    create.rendition = 3;
    create.presentation = "picture";
    create.width = 300;
    create.height = 200;
    create.slots = {{0, 1200}, {240000, 1200}};
    const std::string bodies[] = {
        encodeRequest(1, ToMedium(create)),
        encodeRequest(2, ToMedium(SubdocumentEdit{2, {{0, 4, "x"}}, "l"})),
        encodeAnswer(Id(Integer{1}), Initialized{})};
    for (const std::string& body : bodies)
        for (std::size_t cut = 0; cut < body.size(); ++cut)
            EXPECT_THAT(forMedium(body.substr(0, cut)), HasSubstr("violation")) << cut;
    std::mt19937 random(3);
    int refused = 0;
    for (int round = 0; round < 20000; ++round) {
        std::string damaged = bodies[random() % 3];
        for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips)
            damaged[random() % damaged.size()] ^= static_cast<char>(1u << random() % 8);
        refused += forMedium(damaged).starts_with("asked") ? 0 : 1;
        (void)decodeForHost(damaged, [](Integer id) { return static_cast<std::size_t>(id % 5); });
    }
    EXPECT_GT(refused, 1000);
}

// --- bounds ------------------------------------------------------------------------------------

// Gives one string or list of a message, the one of number `target`, more than it may have, and
// every number a value that it may have.
class Overfill {
public:
    explicit Overfill(int target) : target_(target) {}

    template <class T> void field(const char* name, T& value, Bound<T> bound) {
        name_ = name;
        visit(value, bound);
    }
    template <class T> void option(const char* name, T& value, Bound<T> bound) {
        field(name, value, bound);
    }
    template <class T>
    requires(!Bounded<T>) void field(const char* name, T& value) { field(name, value, {}); }
    template <class T>
    requires(!Bounded<T>) void option(const char* name, T& value) { field(name, value, {}); }
    void pair(const char*, Integer&, Integer&, Range) {}
    void numbersOrNull(const char* name, std::vector<double>& values, Count count) {
        field(name, values, count);
    }
    template <class F> void inside(const char*, F describeInner) { describeInner(*this); }

    void visit(std::string& value, Length length) {
        // One of pixels would be longer than a message.
        if (length.most < longestBody && isNext(length.isShown))
            value.assign(length.most + 1, 'x');
    }
    template <class T> void visit(std::vector<T>& values, Count count) {
        values.resize(isNext(count.isShown) ? count.most + 1 : 1);
        for (T& value : values)
            visit(value, eachOf<T>(count));
    }
    template <class T> void visit(T& value, Bound<T> bound) {
        if constexpr (IsOptional<T>::value)
            visit(value.emplace(), bound);
        else if constexpr (Bounded<T>)
            value = static_cast<T>(std::max(bound.from, std::min(bound.to, 1.0)));
        else if constexpr (std::is_class_v<T>)
            describe(*this, value);
    }

    [[nodiscard]] bool found() const { return !found_.empty(); }
    [[nodiscard]] bool isShown() const { return isShown_; }
    [[nodiscard]] const std::string& where() const { return found_; }

private:
    bool isNext(bool isShown) {
        if (seen_++ != target_)
            return false;
        isShown_ = isShown;
        found_ = name_;
        return true;
    }

    int target_, seen_ = 0;
    bool isShown_ = false;
    std::string name_, found_;
};

// Sends the message once for each of its strings and lists; how many these are.
template <class Decode, class T> int overfillEach(T message, Decode read) {
    for (int target = 0;; ++target) {
        T call = message;
        Overfill overfill(target);
        describe(overfill, call);
        if (!overfill.found())
            return target;
        const std::string came = read(call);
        if (overfill.isShown())
            EXPECT_THAT(came, testing::AnyOf(testing::StartsWith("asked"),
                                             testing::StartsWith("told"), "answered"))
                << overfill.where() << " is cut by the writer";
        else
            EXPECT_THAT(came,
                        testing::AnyOf(HasSubstr("is longer than"), HasSubstr("holds more than")))
                << T{}.method << ": " << overfill.where();
    }
}

TEST(Wire, NoStringAndNoListIsLongerThanItsBound) {
    int fields = 0;
    forEachCall<ToMedium>([&](auto call) {
        fields += overfillEach(call, [](const auto& message) {
            return forMedium(IsRequest<decltype(call)> ? encodeRequest(1, ToMedium(message))
                                                       : encodeNotification(ToMedium(message)));
        });
    });
    forEachCall<ToHost>([&](auto call) {
        fields += overfillEach(call, [](const auto& message) {
            const std::string body = IsRequest<decltype(call)>
                                         ? encodeRequest(1, ToHost(message))
                                         : encodeNotification(ToHost(message));
            return described(decodeForHost(body, nothingAwaited));
        });
    });
    EXPECT_EQ(fields, 56);
}

TEST(Wire, AnswersKeepToTheirBounds) {
    const auto answer = [](auto call, const AnyResult& result) {
        const std::size_t index = ToMedium(call).index();
        return described(decodeForHost(encodeAnswer(Id(Integer{1}), result),
                                       [index](Integer) { return index; }));
    };
    Initialized introduction;
    introduction.menus.resize(1001);
    introduction.name.assign(5000, 'n');
    EXPECT_EQ(answer(Initialize{}, introduction), "answered"); // cut: they are only shown
    introduction.capabilities.resize(101);
    EXPECT_THAT(answer(Initialize{}, introduction), HasSubstr("holds more than 100 items"));
    EXPECT_THAT(answer(ParameterList{}, Parameters{std::vector<ParameterValue>(1001)}),
                HasSubstr("holds more than 1000 items"));
    EXPECT_THAT(answer(ValueRead{}, Values{std::vector<double>(1001), {}}),
                HasSubstr("holds more than 1000 items"));
    EXPECT_THAT(answer(ValueRead{}, Values{{}, std::vector<std::string>(1001)}),
                HasSubstr("holds more than 1000 items"));
    EXPECT_EQ(answer(ValueRead{}, Values{{1}, {std::string(5000, 'x')}}), "answered"); // cut
    EXPECT_THAT(answer(ScriptEvaluate{}, Evaluated{std::string(longestText.most + 1, 'x')}),
                HasSubstr("is longer than 8388608 bytes"));
    const auto refused =
        decodeForHost(R"({"jsonrpc":"2.0","id":1,"error":{"code":-32003,"message":")" +
                          std::string(100'000, 'x') + "\"}}",
                      [](Integer) { return ToMedium(Ping{}).index(); });
    EXPECT_LE(std::get<Error>(std::get<Answered>(refused).outcome).message.size(),
              longestSentence.most);
}

TEST(Wire, WhatIsShownIsCutBetweenCharacters) {
    EXPECT_EQ(shortened("abcdef", {6}), "abcdef");
    EXPECT_EQ(shortened("abcdefg", {6}), "abc\xe2\x80\xa6");
    EXPECT_EQ(shortened("ab\xc3\xa9\xc3\xa9\xc3\xa9", {6}), "ab\xe2\x80\xa6");
    ProgressEnd said{1, {}};
    for (int i = 0; i < 4000; ++i)
        said.message += "\xc3\xa9";
    const auto decoded = decodeForHost(encodeNotification(ToHost(said)), nothingAwaited);
    const auto& message = std::get<ProgressEnd>(std::get<Told<ToHost>>(decoded).call).message;
    EXPECT_LE(message.size(), longestSentence.most);
    EXPECT_EQ(text::asUtf8(message), message);
    EXPECT_TRUE(message.ends_with("\xc3\xa9\xe2\x80\xa6"));
}

} // namespace
} // namespace ipc
