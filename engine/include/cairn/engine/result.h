// The outcome of a call that the outside world can make fail: a value, or an error message for a person.
// Invariant: exactly one of the two is present; asking for the one that is absent is a bug and asserts.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace cairn::engine {

/// Says what failed, on which thing, and what would be right; one line, without a trailing full stop or
/// newline.
struct Error {
    std::string message;
};

template <typename T>
class [[nodiscard]] Result {
  public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return state_.index() == 0; }

    T& value() & { return checked_value(); }
    const T& value() const& { return const_cast<Result*>(this)->checked_value(); }
    T&& value() && { return std::move(checked_value()); }

    const Error& error() const {
        assert(state_.index() == 1);
        return *std::get_if<1>(&state_);
    }

    T& operator*() & { return checked_value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(checked_value()); }
    T* operator->() { return &checked_value(); }
    const T* operator->() const { return &value(); }

  private:
    T& checked_value() {
        assert(state_.index() == 0);
        return *std::get_if<0>(&state_);
    }

    std::variant<T, Error> state_;
};

/// A call that gives nothing but may fail: `return {};` is success.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    explicit operator bool() const { return !error_.has_value(); }

    const Error& error() const {
        assert(error_.has_value());
        return *error_;
    }

  private:
    std::optional<Error> error_;
};

}  // namespace cairn::engine
