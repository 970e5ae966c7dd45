// The two visitors of fields.h: JSON from a message, and a message from JSON.
// Only wire.cpp includes this: the JSON library stays out of every other file.
#pragma once

#include "ipc/fields.h"
#include "ipc/wire.h"
#include "text/characters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <type_traits>

namespace ipc {

using Json = nlohmann::json;

// The names of an enumeration's values on the wire, in order.
inline constexpr std::array modeNames{"play", "edit", "batch"};
inline constexpr std::array scopeNames{"rendition", "subdocument"};
inline constexpr std::array inputNames{"press",     "release",     "move",     "wheel",
                                       "key-press", "key-release", "focus-in", "focus-out"};
inline constexpr std::array buttonNames{"none", "left", "middle", "right", "back", "forward"};
inline constexpr std::array modifierNames{"shift", "control", "alt", "meta"};
inline constexpr std::array cursorNames{"arrow", "hand", "grab", "grabbing",
                                        "cross", "text", "wait", "forbidden"};
inline constexpr std::array stateNames{"current", "draft", "computing", "stale", "failed"};
inline constexpr std::array severityNames{"error", "warning"};

constexpr const auto& namesOf(Mode) { return modeNames; }
constexpr const auto& namesOf(Scope) { return scopeNames; }
constexpr const auto& namesOf(InputType) { return inputNames; }
constexpr const auto& namesOf(Button) { return buttonNames; }
constexpr const auto& namesOf(Modifier) { return modifierNames; }
constexpr const auto& namesOf(CursorShape) { return cursorNames; }
constexpr const auto& namesOf(MotionState) { return stateNames; }
constexpr const auto& namesOf(Severity) { return severityNames; }

template <class T> struct IsOptional : std::false_type {};
template <class T> struct IsOptional<std::optional<T>> : std::true_type {};
template <class T> struct IsVector : std::false_type {};
template <class T> struct IsVector<std::vector<T>> : std::true_type {};

// The kind of bound that a field keeps to, by its type: every string, list and number has one.
struct NoBound {};
template <class T> struct BoundOf { using Type = NoBound; };
template <class T>
requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) struct BoundOf<T> {
    using Type = Range;
};
template <> struct BoundOf<std::string> { using Type = Length; };
template <class T> struct BoundOf<std::vector<T>> { using Type = Count; };
template <class T> struct BoundOf<std::optional<T>> : BoundOf<T> {};
template <class T> using Bound = typename BoundOf<T>::Type;
template <class T>
concept Bounded = !std::is_same_v<Bound<T>, NoBound>;

// The bound of each item of a list.
template <class Item> constexpr Bound<Item> eachOf(const Count& list) {
    if constexpr (std::is_same_v<Item, std::string>)
        return list.each;
    else
        return {};
}

class Writer {
public:
    template <class T> static Json object(const T& message) {
        Writer writer;
        // describe() serves reader and writer; a writer changes nothing.
        describe(writer, const_cast<T&>(message));
        return std::move(writer.json_);
    }

    template <class T> void field(const char* name, const T& value, Bound<T> bound) {
        if constexpr (IsOptional<T>::value) {
            json_[name] = value ? encoded(*value, bound) : Json(nullptr);
        } else {
            json_[name] = encoded(value, bound);
        }
    }
    template <class T> void option(const char* name, const T& value, Bound<T> bound) {
        if constexpr (IsOptional<T>::value) {
            if (value)
                json_[name] = encoded(*value, bound);
        } else if constexpr (IsVector<T>::value) {
            if (!value.empty())
                json_[name] = encoded(value, bound);
        } else if (std::is_arithmetic_v<T> || std::is_enum_v<T> || value != T{}) {
            json_[name] = encoded(value, bound);
        }
    }
    template <class T>
    requires(!Bounded<T>) void field(const char* name, const T& value) { field(name, value, {}); }
    template <class T>
    requires(!Bounded<T>) void option(const char* name, const T& value) { option(name, value, {}); }
    void pair(const char* name, Integer first, Integer second, Range) {
        json_[name] = Json::array({first, second});
    }
    void numbersOrNull(const char* name, const std::vector<double>& values, Count) {
        Json list = Json::array();
        for (const double value : values)
            list.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
        json_[name] = std::move(list);
    }
    template <class F> void inside(const char* name, F describeInner) {
        Writer inner;
        describeInner(inner);
        json_[name] = std::move(inner.json_);
    }

    template <class T> static Json encoded(const T& value, Bound<T> bound) {
        if constexpr (std::is_same_v<T, std::string>) {
            return text::asUtf8(bound.isShown ? shortened(value, bound) : value);
        } else if constexpr (std::is_enum_v<T>) {
            return namesOf(value)[static_cast<std::size_t>(value)];
        } else if constexpr (IsVector<T>::value) {
            Json list = Json::array();
            const std::size_t count =
                bound.isShown ? std::min(value.size(), bound.most) : value.size();
            for (std::size_t i = 0; i < count; ++i)
                list.push_back(encoded(value[i], eachOf<typename T::value_type>(bound)));
            return list;
        } else if constexpr (std::is_arithmetic_v<T>) {
            return value;
        } else {
            return object(value);
        }
    }

private:
    Json json_ = Json::object();
};

// Stops at the first fault; the fields read so far are then not used.
class FieldReader {
public:
    FieldReader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
        if (!json_.is_object())
            fail(place_ + " must be an object");
    }

    [[nodiscard]] const std::string& fault() const { return fault_; }

    template <class T> void field(const char* name, T& value, Bound<T> bound) {
        const Json* found = find(name);
        if constexpr (IsOptional<T>::value) {
            if (!found || found->is_null())
                return;
            value.emplace();
            read(*found, *value, named(name), bound);
        } else if (found) {
            read(*found, value, named(name), bound);
        } else {
            fail(named(name) + " is missing");
        }
    }
    template <class T> void option(const char* name, T& value, Bound<T> bound) {
        if constexpr (IsOptional<T>::value)
            field(name, value, bound);
        else if (const Json* found = find(name); found && !found->is_null())
            read(*found, value, named(name), bound);
    }
    template <class T>
    requires(!Bounded<T>) void field(const char* name, T& value) { field(name, value, {}); }
    template <class T>
    requires(!Bounded<T>) void option(const char* name, T& value) { option(name, value, {}); }
    void pair(const char* name, Integer& first, Integer& second, Range range) {
        const Json* found = find(name);
        if (!found || !found->is_array() || found->size() != 2)
            return fail(named(name) + " must be two numbers");
        read((*found)[0], first, named(name) + "[0]", range);
        read((*found)[1], second, named(name) + "[1]", range);
    }
    void numbersOrNull(const char* name, std::vector<double>& values, Count count) {
        const Json* found = find(name);
        if (!found || !found->is_array())
            return fail(named(name) + " must be a list of numbers");
        if (found->size() > count.most)
            return failCount(named(name), count);
        for (const Json& item : *found) {
            double value = std::nan("");
            if (!item.is_null())
                read(item, value, named(name), anyNumber);
            values.push_back(value);
        }
    }
    template <class F> void inside(const char* name, F describeInner) {
        const Json* found = find(name);
        if (!found)
            return fail(named(name) + " is missing");
        FieldReader inner(*found, named(name));
        if (inner.fault().empty())
            describeInner(inner);
        fail(inner.fault());
    }

    void read(const Json& json, std::string& value, const std::string& place, Length length) {
        if (!json.is_string())
            return fail(place + " must be a string");
        const auto& found = json.get_ref<const std::string&>();
        if (found.size() > length.most)
            return fail(place + " is longer than " + std::to_string(length.most) + " bytes");
        value = found;
    }
    void read(const Json& json, bool& value, const std::string& place, NoBound) {
        if (!json.is_boolean())
            return fail(place + " must be true or false");
        value = json.get<bool>();
    }
    void read(const Json& json, double& value, const std::string& place, Range range) {
        if (!json.is_number())
            return fail(place + " must be a number");
        value = json.get<double>();
        checkRange(value, place, range);
    }
    template <std::integral T>
    requires(!std::is_same_v<T, bool>) void read(const Json& json, T& value,
                                                 const std::string& place, Range range) {
        double number = 0;
        read(json, number, place, range);
        if (!fault_.empty())
            return;
        if (number != std::floor(number) || std::abs(number) > natural.to)
            return fail(place + " must be a whole number");
        value = static_cast<T>(number);
    }
    template <class E>
    requires std::is_enum_v<E>
    void read(const Json& json, E& value, const std::string& place, NoBound) {
        const std::string text = json.is_string() ? json.get<std::string>() : std::string();
        std::string expected;
        std::size_t index = 0;
        for (const char* name : namesOf(value)) {
            if (text == name) {
                value = static_cast<E>(index);
                return;
            }
            expected += (index++ == 0 ? "" : ", ") + std::string(name);
        }
        fail(place + " must be one of " + expected);
    }
    template <class T>
    void read(const Json& json, std::vector<T>& values, const std::string& place, Count count) {
        if (!json.is_array())
            return fail(place + " must be a list");
        if (json.size() > count.most)
            return failCount(place, count);
        for (std::size_t i = 0; i < json.size() && fault_.empty(); ++i)
            read(json[i], values.emplace_back(), place + "[" + std::to_string(i) + "]",
                 eachOf<T>(count));
    }
    template <class T>
    requires std::is_class_v<T>
    void read(const Json& json, T& value, const std::string& place, NoBound) {
        FieldReader inner(json, place);
        if (inner.fault().empty())
            describe(inner, value);
        fail(inner.fault());
    }

private:
    const Json* find(const char* name) {
        if (!fault_.empty())
            return nullptr;
        const auto found = json_.find(name);
        return found == json_.end() ? nullptr : &*found;
    }
    std::string named(const char* name) const { return place_ + "." + name; }
    void checkRange(double value, const std::string& place, Range range) {
        if (std::isfinite(value) && value >= range.from && value <= range.to)
            return;
        if (range.to >= natural.to)
            fail(place + (value < range.from ? " must not be negative" : " is out of range"));
        else
            fail(place + " must lie in " + Json(range.from).dump() + " to " +
                 Json(range.to).dump());
    }
    void failCount(const std::string& place, Count count) {
        fail(place + " holds more than " + std::to_string(count.most) + " items");
    }
    void fail(const std::string& sentence) {
        if (fault_.empty())
            fault_ = sentence;
    }

    const Json& json_;
    std::string place_;
    std::string fault_;
};

} // namespace ipc
