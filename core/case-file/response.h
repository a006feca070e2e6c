#pragma once

#include <span>

#include "case-file/message.h"

namespace ravnoves {

/// Why a value does not exist.
struct Reason {
    Message where{};  ///< JSON pointer of the input that is rejected, or of the value
    Message why{};    ///< "must be at least 0", or what the result says

    bool empty() const { return where.empty() && why.empty(); }
    /// The two joined.
    Message message() const { return where.empty() ? why : Message(Text{"%1: %2"}, where, why); }
    friend bool operator==(const Reason&, const Reason&) = default;
};

inline constexpr Text no_value = Text::tr("no value");

/// Values of a result as functions of numbers of the input, for a study. For one thread at a time.
class Response {
  public:
    Response() = default;
    Response(const Response&) = delete;
    Response& operator=(const Response&) = delete;
    virtual ~Response() = default;

    /// @param x  the inputs, in the units of their keys
    /// @param y  set to the watched values, in the units of their keys; NaN for a missing one
    /// @return false where one of them does not exist: see reason()
    virtual bool evaluate(std::span<const double> x, std::span<double> y) = 0;
    /// Of a watched value that is an angle, 360 or 720; else 0. Known once it has had a value.
    virtual double period(std::size_t /*watched*/) const { return 0.0; }
    /// Of the last rejection.
    const Reason& reason() const { return reason_; }

  protected:
    Reason reason_;
};

}  // namespace ravnoves
