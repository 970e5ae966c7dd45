#include "ipc/wire.h"

#include "ipc/json_fields.h"
#include "text/characters.h"

namespace ipc {
namespace {

// LIMIT: no message of the protocol nests deeper or holds more values than this.
constexpr std::size_t deepest = 32;
constexpr std::size_t mostValues = 100'000;

// Why the text must not be given to the parser, or nullptr. Counts brackets and commas outside
// strings; that they are well placed is the parser's to find.
const char* tooLarge(std::string_view text) {
    std::size_t depth = 0, values = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > deepest)
                return "a message that nests too deeply";
            ++values;
        } else if (c == '}' || c == ']') {
            depth -= depth > 0 ? 1 : 0;
        } else if (c == ',') {
            ++values;
        }
        if (values > mostValues)
            return "a message of more than 100,000 values";
    }
    return nullptr;
}

Json encodedId(const Id& id) {
    return std::visit([](const auto& value) { return Json(value); }, id);
}

std::optional<Id> idOf(const Json& json) {
    if (json.is_number_integer())
        return json.get<Integer>();
    if (json.is_string() && json.get_ref<const std::string&>().size() <= 100)
        return json.get<std::string>();
    return std::nullopt;
}

template <class Call> Json callObject(const Call& call) {
    return std::visit(
        [](const auto& message) {
            return Json{{"jsonrpc", "2.0"},
                        {"method", message.method},
                        {"params", Writer::object(message)}};
        },
        call);
}

std::string text(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <class Call> std::string request(Integer id, const Call& call) {
    Json json = callObject(call);
    json["id"] = id;
    return text(json);
}

template <class T>
std::optional<std::string> readInto(T& message, const Json& json, const char* place) {
    FieldReader reader(json, place);
    if (reader.fault().empty())
        describe(reader, message);
    return reader.fault().empty() ? std::nullopt : std::optional(reader.fault());
}

// Two answers are bare lists.
template <class T>
std::optional<std::string> readListInto(T& message, const Json& json, const char* place,
                                        Count count) {
    static const Json nothing = Json::object();
    FieldReader reader(nothing, place);
    reader.read(json, message.items, place, count);
    return reader.fault().empty() ? std::nullopt : std::optional(reader.fault());
}
constexpr Count boundOf(const Presentations&) { return mostEntries; }
constexpr Count boundOf(const Parameters&) { return mostParameters; }
constexpr Count boundOf(const ValueOffers&) { return mostOffers; }
std::optional<std::string> readInto(Presentations& m, const Json& json, const char* place) {
    return readListInto(m, json, place, boundOf(m));
}
std::optional<std::string> readInto(Parameters& m, const Json& json, const char* place) {
    return readListInto(m, json, place, boundOf(m));
}

std::optional<std::string> readInto(ValueOffers& m, const Json& json, const char* place) {
    return readListInto(m, json, place, boundOf(m));
}

// Calls `use` with a default value of the alternative at `index`.
template <class Variant, class F, std::size_t... I>
void withAlternative(std::size_t index, F use, std::index_sequence<I...>) {
    (void)((I == index && (use(std::variant_alternative_t<I, Variant>{}), true)) || ...);
}
template <class Variant, class F> void withAlternative(std::size_t index, F use) {
    withAlternative<Variant>(index, use, std::make_index_sequence<std::variant_size_v<Variant>>{});
}

template <class Received>
Decoded<Received> decodeCall(const Json& json, const std::string& method) {
    static const Json noParameters = Json::object();
    const auto params = json.find("params");
    std::optional<Id> id;
    if (json.contains("id")) {
        id = idOf(json["id"]);
        if (!id)
            return Violation{"a request whose id is neither a whole number nor a short string"};
    }
    Decoded<Received> decoded = Ignored{};
    if (id)
        decoded = Unanswerable{*id, {ErrorCode::methodNotFound, "no method \"" + method + "\""}};
    const auto tryAlternative = [&](auto message) {
        using T = decltype(message);
        if (method != T::method)
            return;
        const auto fault =
            readInto(message, params == json.end() ? noParameters : *params, T::method);
        if (IsRequest<T> && !id)
            decoded = Violation{method + " is a request and came without an id"};
        else if (fault && id)
            decoded = Unanswerable{*id, {ErrorCode::invalidParameters, *fault}};
        else if (fault)
            decoded = Violation{*fault};
        else if (id && !IsRequest<T>)
            decoded = Unanswerable{*id, {ErrorCode::invalidRequest, method + " is a notification"}};
        else if (id)
            decoded = Asked<Received>{*id, std::move(message)};
        else
            decoded = Told<Received>{std::move(message)};
    };
    for (std::size_t i = 0; i < std::variant_size_v<Received>; ++i)
        withAlternative<Received>(i, tryAlternative);
    return decoded;
}

std::variant<Error, Violation> decodeError(const Json& json) {
    if (!json.is_object() || !json.contains("code") || !json["code"].is_number_integer() ||
        !json.contains("message") || !json["message"].is_string())
        return Violation{"an error that has no code and message"};
    return Error{json["code"].get<Integer>(),
                 shortened(json["message"].get_ref<const std::string&>(), longestSentence)};
}

template <class Sent, class Received>
Decoded<Received> decodeAnswer(const Json& json, const AwaitedCall& awaited) {
    const auto error = json.find("error");
    std::optional<Error> refusal;
    if (error != json.end() && (!error->is_null() || !json.contains("result"))) {
        auto read = decodeError(*error);
        if (auto* violation = std::get_if<Violation>(&read))
            return *violation;
        refusal = std::get<Error>(read);
    }
    if (refusal && (!json.contains("id") || json["id"].is_null()))
        return Violation{"the other side could not read a message: " + refusal->message};
    const auto id = json.contains("id") && json["id"].is_number_integer()
                        ? std::optional(json["id"].get<Integer>())
                        : std::nullopt;
    const auto index = id ? awaited(*id) : std::nullopt;
    if (!index)
        return Violation{"an answer to a request that was not made"};
    if (refusal)
        return Answered{*id, *refusal};
    Decoded<Received> decoded = Violation{"an answer to a notification"};
    withAlternative<Sent>(*index, [&](auto call) {
        if constexpr (IsRequest<decltype(call)>) {
            typename decltype(call)::Result result;
            const std::string place = "the answer to " + std::string(call.method);
            if (const auto fault = readInto(result, json["result"], place.c_str()))
                decoded = Violation{*fault};
            else
                decoded = Answered{*id, AnyResult(std::move(result))};
        }
    });
    return decoded;
}

template <class Received, class Sent>
Decoded<Received> decode(std::string_view body, const AwaitedCall& awaited) {
    if (const char* sentence = tooLarge(body))
        return Violation{sentence};
    const Json json = Json::parse(body, nullptr, false);
    if (json.is_discarded())
        return Violation{"a message that is not JSON"};
    if (!json.is_object() || json.value("jsonrpc", Json()) != "2.0")
        return Violation{"a message that is not a JSON-RPC 2.0 object"};
    const auto method = json.find("method");
    if (method != json.end()) {
        if (!method->is_string() || method->get_ref<const std::string&>().size() > 200)
            return Violation{"a message whose method is not a short string"};
        return decodeCall<Received>(json, method->get<std::string>());
    }
    if (!json.contains("result") && !json.contains("error"))
        return Violation{"a message without method, result and error"};
    return decodeAnswer<Sent, Received>(json, awaited);
}

} // namespace

std::string encodeRequest(Integer id, const ToMedium& call) { return request(id, call); }
std::string encodeRequest(Integer id, const ToHost& call) { return request(id, call); }
std::string encodeNotification(const ToMedium& call) { return text(callObject(call)); }
std::string encodeNotification(const ToHost& call) { return text(callObject(call)); }

std::string encodeAnswer(const Id& id, const AnyResult& result) {
    const auto encoded = [](const auto& value) {
        if constexpr (requires { value.items; })
            return Writer::encoded(value.items, boundOf(value));
        else
            return Writer::object(value);
    };
    return text(
        {{"jsonrpc", "2.0"}, {"id", encodedId(id)}, {"result", std::visit(encoded, result)}});
}

std::string encodeError(const Id& id, const Error& error) {
    return text({{"jsonrpc", "2.0"},
                 {"id", encodedId(id)},
                 {"error",
                  {{"code", error.code},
                   {"message", text::asUtf8(shortened(error.message, longestSentence))}}}});
}

Decoded<ToMedium> decodeForMedium(std::string_view body, const AwaitedCall& awaited) {
    return decode<ToMedium, ToHost>(body, awaited);
}
Decoded<ToHost> decodeForHost(std::string_view body, const AwaitedCall& awaited) {
    return decode<ToHost, ToMedium>(body, awaited);
}

} // namespace ipc
