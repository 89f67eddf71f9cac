#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace echotrail {

/// Why something could not be done: one line, fit to be shown to the person who asked for it.
struct Error {
    std::string message;
};

/// A value, or the reason there is none. The names are those of std::expected, which replaces it in C++23.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    bool has_value() const { return content_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    T& value() & { return assertValue(), std::get<0>(content_); }
    const T& value() const& { return assertValue(), std::get<0>(content_); }
    T&& value() && { return assertValue(), std::get<0>(std::move(content_)); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    const std::string& error() const { return std::get<1>(content_).message; }

private:
    void assertValue() const { assert(has_value()); }
    std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    bool has_value() const { return !error_; }
    explicit operator bool() const { return has_value(); }
    const std::string& error() const { return error_->message; }

private:
    std::optional<Error> error_;
};

}  // namespace echotrail
