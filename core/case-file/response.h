#pragma once

#include <span>
#include <string>

namespace ravnoves {

/// Values of a result as functions of numbers of the input, for a study. For one thread at a time.
class Response {
  public:
    Response() = default;
    Response(const Response&) = delete;
    Response& operator=(const Response&) = delete;
    virtual ~Response() = default;

    /// @param x  the inputs, in the units of their keys
    /// @param y  set to the watched values, in the units of theirs; not a number where there is
    /// none
    /// @return false where one of them does not exist: reason() says why
    virtual bool evaluate(std::span<const double> x, std::span<double> y) = 0;
    /// Of the last refusal; in English.
    const std::string& reason() const { return reason_; }

  protected:
    std::string reason_;
};

}  // namespace ravnoves
