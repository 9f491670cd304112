// The outcome of a call that the outside world can make fail. Invariant: a Result holds a value or an error,
// never both.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cairn::physics {

/// What went wrong: names the thing, the value and the rule, in one sentence without a final stop. Where
/// several rules are broken that do not depend on each other, it is a sentence for each, with kAndAlso
/// between.
struct Error {
    std::string message;
};
inline constexpr std::string_view kAndAlso = "; and ";

namespace detail {
/// Prints the message and ends the program: a failed Result was used as if it held a value.
[[noreturn]] void fail_unchecked_result(const Error& error);
}  // namespace detail

/// A value of type T, or the error that prevented it. Test it before use; `value()` of an error ends the
/// program with the error's message, so that a forgotten check is loud and never undefined behaviour.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : value_(std::move(value)) {}      // NOLINT: conversion is the point
    Result(Error error) : error_(std::move(error)) {}  // NOLINT: conversion is the point

    explicit operator bool() const { return value_.has_value(); }
    [[nodiscard]] T& value() & { return check(), *value_; }
    [[nodiscard]] const T& value() const& { return check(), *value_; }
    /// By value, so that `for (x : call().value())` walks over something that lives.
    T value() && { return check(), *std::move(value_); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    [[nodiscard]] const Error& error() const { return error_; }

  private:
    void check() const {
        if (!value_) detail::fail_unchecked_result(error_);
    }

    std::optional<T> value_;
    Error error_;
};

/// Success without a value, or an error.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}  // NOLINT: conversion is the point

    explicit operator bool() const { return !error_; }
    void value() const {
        if (error_) detail::fail_unchecked_result(*error_);
    }
    [[nodiscard]] const Error& error() const { return *error_; }

  private:
    std::optional<Error> error_;
};

}  // namespace cairn::physics
