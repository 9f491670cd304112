// One description per binding. `function<&f>(...)` makes, from a plain C++ function and the names of its
// parameters, all that is needed: the call from Lua with its argument checks and their messages, the
// reference and the editor annotations. Invariant: types are written once, in the C++ function; names, units
// and meaning once, beside it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <lua.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include <cairn/engine/result.h>
#include <cairn/physics/result.h>

#include "bind/range.h"
#include "lua/errors.h"

namespace cairn::scripting {

struct FieldSet;

struct Function {
    const char* name;
    /// "x [m], y [m], angle [rad] = 0": in the order of the C++ parameters; a default marks what may be left
    /// out.
    const char* parameters;
    /// "x [m], y [m]".
    const char* results;
    const char* doc;
    lua_CFunction call;
    std::span<const std::string_view>
        parameter_types;  ///< as the annotations write them: "number", "Body", "table?"
    std::span<const std::string_view> result_types;
    /// What numbers each parameter may be; null: any finite one, or it is no number.
    std::span<const Range* const> parameter_ranges;
    /// The fields of the table parameter, if it has described ones.
    const FieldSet* fields = nullptr;
};

/// A parameter or result of a description, taken apart.
struct Parameter {
    std::string_view name;
    std::string_view unit;           ///< empty: none
    std::string_view default_value;  ///< empty: none
};
std::vector<Parameter> parse_parameters(std::string_view text);

/// "cairn.graphics.circle" or "Body:position": what the running binding is called. For messages.
std::string running_name(lua_State* L);

/// Whether the running binding belongs to a type, so that its first argument is the receiver.
bool is_method(lua_State* L);

/// Raises "NAME: PARAMETER is VALUE; expected EXPECTED" at the caller's place.
[[noreturn]] void argument_error(lua_State* L, int index, const std::string& expected);

/// Raises "NAME: PARAMETER is VALUE; expected a number from 0 to 1" for a number that is not in its range, or
/// only beyond what a float holds.
[[noreturn]] void range_error(lua_State* L, int index, const Range& range);

/// Raises "NAME takes 1 argument, 3 given".
[[noreturn]] void count_error(lua_State* L, int most);

/// Raises "NAME: message" at the caller's place.
[[noreturn]] void call_error(lua_State* L, const std::string& message);

/// What the physics says about a field, in the names of the Lua API: without the name of the C++ type before
/// it and the unit behind it, kinds of joints in two words, "nan" without a sign, and places in lists counted
/// from 1.
std::string author_words(std::string_view physics_message);

/// Raises "NAME: message" at the caller's place.
[[noreturn]] inline void call_error(lua_State* L, const physics::Error& error) {
    call_error(L, author_words(error.message));
}
[[noreturn]] inline void call_error(lua_State* L, const engine::Error& error) {
    call_error(L, error.message);
}

// ---- Parameters: Argument<T>::get reads the Lua argument at an index, or raises.

template <class T>
struct Argument;

/// Unless a parameter says more, numbers are finite: no function has a use for others, and they would spread
/// from there to all that they touch.
inline constexpr Range kFinite;

/// The number at an index, or raises.
inline double number_at(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TNUMBER) argument_error(L, index, "a number");
    return lua_tonumber(L, index);
}

template <>
struct Argument<double> {
    static constexpr std::string_view kType = "number";
    static double get(lua_State* L, int index) {
        const double value = number_at(L, index);
        if (!(std::fabs(value) <= kFinite.high)) range_error(L, index, kFinite);
        return value;
    }
};

template <>
struct Argument<float> {
    static constexpr std::string_view kType = "number";
    static float get(lua_State* L, int index) {
        const double value = number_at(L, index);
        if (!(std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max())))
            range_error(L, index, kFinite);
        return static_cast<float>(value);
    }
};

/// Whether a value is a whole number: 2^3 and 16/2 are floats in Lua, but whole.
inline bool is_integral(lua_State* L, int index) {
    int is_integer = 0;
    lua_tointegerx(L, index, &is_integer);
    return is_integer != 0 && lua_type(L, index) == LUA_TNUMBER;  // and no string of digits
}

template <>
struct Argument<std::int64_t> {
    static constexpr std::string_view kType = "integer";
    static std::int64_t get(lua_State* L, int index) {
        if (!is_integral(L, index)) argument_error(L, index, "an integer");
        return lua_tointeger(L, index);
    }
};

/// A number of a range. T is float, double or std::int64_t.
template <const Range& kAllowed, class T>
struct Ranged {
    T value;

    constexpr Ranged(T number) : value(number) {}
    constexpr operator T() const { return value; }
};
template <const Range& kAllowed, class T>
struct Argument<Ranged<kAllowed, T>> {
    static constexpr std::string_view kType = Argument<T>::kType;
    static constexpr const Range* kRange = &kAllowed;
    static Ranged<kAllowed, T> get(lua_State* L, int index) {
        if constexpr (std::is_integral_v<T>) {
            const T value = Argument<T>::get(L, index);
            if (!kAllowed.contains(static_cast<double>(value))) range_error(L, index, kAllowed);
            return value;
        } else {
            const double value = number_at(L, index);
            if (!kAllowed.contains(value) || (std::is_same_v<T, float> && is_beyond_float(value)))
                range_error(L, index, kAllowed);
            return static_cast<T>(value);
        }
    }
};
using Share = Ranged<kShare, float>;
using NotNegative = Ranged<kNotNegative, float>;
using Positive = Ranged<kPositive, float>;
using StepTime = Ranged<kStepTime, float>;
using Seconds = Ranged<kNotNegative, double>;
using Count = Ranged<kNotNegative, std::int64_t>;

template <>
struct Argument<bool> {
    static constexpr std::string_view kType = "boolean";
    static bool get(lua_State* L, int index) {
        if (lua_type(L, index) != LUA_TBOOLEAN) argument_error(L, index, "true or false");
        return lua_toboolean(L, index) != 0;
    }
};

/// Valid as long as the argument stands on the stack.
template <>
struct Argument<std::string_view> {
    static constexpr std::string_view kType = "string";
    static std::string_view get(lua_State* L, int index) {
        if (lua_type(L, index) != LUA_TSTRING) argument_error(L, index, "a string");
        std::size_t length = 0;
        const char* text = lua_tolstring(L, index, &length);
        return {text, length};
    }
};

/// An argument that the function reads itself.
struct TableArgument {
    int index;
};
template <>
struct Argument<TableArgument> {
    static constexpr std::string_view kType = "table";
    static TableArgument get(lua_State* L, int index) {
        if (lua_type(L, index) != LUA_TTABLE) argument_error(L, index, "a table");
        return {index};
    }
};

struct FunctionArgument {
    int index;
};
template <>
struct Argument<FunctionArgument> {
    static constexpr std::string_view kType = "function";
    static FunctionArgument get(lua_State* L, int index) {
        if (lua_type(L, index) != LUA_TFUNCTION) argument_error(L, index, "a function");
        return {index};
    }
};

/// All further arguments, as many as there are; only as the last parameter.
struct FurtherArguments {
    int first;
    int count;
};
template <>
struct Argument<FurtherArguments> {
    static constexpr std::string_view kType = "any";
    static FurtherArguments get(lua_State* L, int index) {
        return {index, std::max(lua_gettop(L) - index + 1, 0)};
    }
};

/// Any value, nil included.
struct AnyArgument {
    int index;
};
template <>
struct Argument<AnyArgument> {
    static constexpr std::string_view kType = "any";
    static AnyArgument get(lua_State*, int index) { return {index}; }
};

template <class T>
struct Argument<std::optional<T>> {
    static constexpr std::string_view kType = Argument<T>::kType;
    static std::optional<T> get(lua_State* L, int index) {
        if (lua_isnoneornil(L, index)) return std::nullopt;
        return Argument<T>::get(L, index);
    }
};

/// The range of a parameter, also of one that may be left out; or null.
template <class T>
constexpr const Range* range_of(std::type_identity<T>) {
    if constexpr (requires { Argument<T>::kRange; }) return Argument<T>::kRange;
    return nullptr;
}
template <class T>
constexpr const Range* range_of(std::type_identity<std::optional<T>>) {
    return range_of(std::type_identity<T>{});
}

// ---- Results: Returned<T>::push pushes and counts.

/// For functions that push their results themselves; the description must then name their types
/// (`results_of`).
struct Pushed {
    int count;
};

template <class T>
struct Returned;

template <>
struct Returned<double> {
    static constexpr std::array<std::string_view, 1> kTypes = {"number"};
    static int push(lua_State* L, double value) { return lua_pushnumber(L, value), 1; }
};
template <>
struct Returned<float> {
    static constexpr std::array<std::string_view, 1> kTypes = {"number"};
    static int push(lua_State* L, float value) { return lua_pushnumber(L, static_cast<double>(value)), 1; }
};
template <>
struct Returned<std::int64_t> {
    static constexpr std::array<std::string_view, 1> kTypes = {"integer"};
    static int push(lua_State* L, std::int64_t value) { return lua_pushinteger(L, value), 1; }
};
template <>
struct Returned<bool> {
    static constexpr std::array<std::string_view, 1> kTypes = {"boolean"};
    static int push(lua_State* L, bool value) { return lua_pushboolean(L, value ? 1 : 0), 1; }
};
template <>
struct Returned<std::string_view> {
    static constexpr std::array<std::string_view, 1> kTypes = {"string"};
    static int push(lua_State* L, std::string_view value) {
        return lua_pushlstring(L, value.data(), value.size()), 1;
    }
};
template <>
struct Returned<std::string> {
    static constexpr std::array<std::string_view, 1> kTypes = {"string"};
    static int push(lua_State* L, const std::string& value) {
        return Returned<std::string_view>::push(L, value);
    }
};
template <>
struct Returned<Pushed> {
    static constexpr std::array<std::string_view, 0> kTypes = {};
    static int push(lua_State*, Pushed pushed) { return pushed.count; }
};

template <class... T>
struct Returned<std::tuple<T...>> {
    static constexpr std::array<std::string_view, sizeof...(T)> kTypes = {Returned<T>::kTypes[0]...};
    static int push(lua_State* L, const std::tuple<T...>& values) {
        return std::apply([L](const T&... value) { return (Returned<T>::push(L, value) + ... + 0); }, values);
    }
};

template <>
struct Returned<physics::Result<void>> {
    static constexpr std::array<std::string_view, 0> kTypes = {};
    static int push(lua_State* L, const physics::Result<void>& result) {
        if (!result) call_error(L, result.error());
        return 0;
    }
};
template <>
struct Returned<engine::Result<void>> {
    static constexpr std::array<std::string_view, 0> kTypes = {};
    static int push(lua_State* L, const engine::Result<void>& result) {
        if (!result) call_error(L, result.error());
        return 0;
    }
};
template <class T>
struct Returned<physics::Result<T>> {
    static constexpr auto kTypes = Returned<T>::kTypes;
    static int push(lua_State* L, const physics::Result<T>& result) {
        if (!result) call_error(L, result.error());
        return Returned<T>::push(L, *result);
    }
};
template <class T>
struct Returned<engine::Result<T>> {
    static constexpr auto kTypes = Returned<T>::kTypes;
    static int push(lua_State* L, const engine::Result<T>& result) {
        if (!result) call_error(L, result.error());
        return Returned<T>::push(L, *result);
    }
};

/// The value of a Result inside a binding, or the error raised.
template <class T>
T value_or_raise(lua_State* L, physics::Result<T> result) {
    if (!result) call_error(L, result.error());
    return *std::move(result);
}
template <class T>
T value_or_raise(lua_State* L, engine::Result<T> result) {
    if (!result) call_error(L, result.error());
    return *std::move(result);
}
inline void check_or_raise(lua_State* L, const physics::Result<void>& result) {
    if (!result) call_error(L, result.error());
}
inline void check_or_raise(lua_State* L, const engine::Result<void>& result) {
    if (!result) call_error(L, result.error());
}

namespace detail {

/// Reads the next argument; the state itself is passed through and takes none.
template <class T>
struct Reader {
    static T next(lua_State* L, int& index) { return Argument<T>::get(L, index++); }
};
template <>
struct Reader<lua_State*> {
    static lua_State* next(lua_State* L, int&) { return L; }
};

/// `of(std::type_identity<P>{})` for each parameter P that is an argument in Lua.
template <class Value, class... T, class Of>
constexpr auto for_arguments(const Of& of) {
    constexpr std::size_t count = (std::size_t{0} + ... + (std::is_same_v<T, lua_State*> ? 0 : 1));
    std::array<Value, count> values{};
    std::size_t next = 0;
    const auto add = [&]<class P>(std::type_identity<P> parameter) {
        if constexpr (!std::is_same_v<P, lua_State*>) values[next++] = of(parameter);
    };
    (add(std::type_identity<T>{}), ...);
    return values;
}

/// More arguments than the function takes. A receiver that is none, or is gone, is told of first.
template <class... A>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_count(lua_State* L, int most) {
    [[maybe_unused]] int index = 1;
    if (is_method(L)) ((index == 1 ? static_cast<void>(Reader<A>::next(L, index)) : void()), ...);
    count_error(L, most);
}

template <auto F>
struct Binding;

template <class R, class... A, R (*F)(A...)>
struct Binding<F> {
    static constexpr auto kParameterTypes = for_arguments<std::string_view, A...>(
        []<class P>(std::type_identity<P>) { return Argument<P>::kType; });
    static constexpr auto kParameterRanges =
        for_arguments<const Range*, A...>([](auto parameter) { return range_of(parameter); });
    static constexpr bool kTakesAnyNumber = (std::is_same_v<A, FurtherArguments> || ...);

    static constexpr auto result_types() {
        if constexpr (std::is_void_v<R>) {
            return std::array<std::string_view, 0>{};
        } else {
            return Returned<R>::kTypes;
        }
    }
    static constexpr auto kResultTypes = result_types();

    static int call(lua_State* L) {
        // Before anything is read, which is cheapest: nothing has to be kept for afterwards.
        constexpr int kMost = static_cast<int>(kParameterTypes.size());
        if (!kTakesAnyNumber && lua_gettop(L) > kMost) [[unlikely]]
            refuse_count<A...>(L, kMost);
        [[maybe_unused]] int index = 1;
        // Braces evaluate from left to right.
        std::tuple<A...> arguments{Reader<A>::next(L, index)...};
        if constexpr (std::is_void_v<R>) {
            std::apply(F, arguments);
            return 0;
        } else {
            return Returned<R>::push(L, std::apply(F, arguments));
        }
    }
};

}  // namespace detail

template <auto F>
constexpr Function function(const char* name, const char* parameters, const char* results, const char* doc,
                            const FieldSet* fields = nullptr) {
    using B = detail::Binding<F>;
    return {name,     parameters,         results,         doc,
            &B::call, B::kParameterTypes, B::kResultTypes, B::kParameterRanges,
            fields};
}

/// For a binding that pushes its results itself (Pushed): with their types written out.
template <auto F, std::size_t N>
constexpr Function function_pushing(const char* name, const char* parameters, const char* results,
                                    const std::array<std::string_view, N>& types, const char* doc,
                                    const FieldSet* fields = nullptr) {
    using B = detail::Binding<F>;
    return {name, parameters, results, doc, &B::call, B::kParameterTypes, types, B::kParameterRanges, fields};
}

}  // namespace cairn::scripting
