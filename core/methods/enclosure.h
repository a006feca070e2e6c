#pragma once

#include <boost/numeric/interval.hpp>
#include <cmath>
#include <limits>

namespace ravnoves::methods {

/// A scalar that is known to lie between two doubles: arithmetic on it encloses what the same
/// arithmetic on any numbers in between would give, rounding included (Boost.Interval). Kernels
/// written as templates take it as they take Real50.
class Enclosure {
  public:
    Enclosure() = default;
    Enclosure(double value) : interval_(value) {}
    Enclosure(double lower, double upper) : interval_(lower, upper) {}

    double lower() const { return interval_.lower(); }
    double upper() const { return interval_.upper(); }

    Enclosure operator-() const { return -interval_; }
    friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
        return a.interval_ + b.interval_;
    }
    friend Enclosure operator-(const Enclosure& a, const Enclosure& b) {
        return a.interval_ - b.interval_;
    }
    friend Enclosure operator*(const Enclosure& a, const Enclosure& b) {
        return a.interval_ * b.interval_;
    }
    friend Enclosure operator/(const Enclosure& a, const Enclosure& b) {
        return a.interval_ / b.interval_;
    }
    friend Enclosure sqrt(const Enclosure& x) { return boost::numeric::sqrt(x.interval_); }
    // The C library rounds these to the nearest double whatever the processor is told.
    friend Enclosure sin(const Enclosure& x) { return outwards(boost::numeric::sin(x.interval_)); }
    friend Enclosure cos(const Enclosure& x) { return outwards(boost::numeric::cos(x.interval_)); }

  private:
    using Rounding = boost::numeric::interval_lib::save_state<
        boost::numeric::interval_lib::rounded_transc_std<double>>;
    using Checking = boost::numeric::interval_lib::checking_base<double>;
    using Interval =
        boost::numeric::interval<double,
                                 boost::numeric::interval_lib::policies<Rounding, Checking>>;

    Enclosure(const Interval& interval) : interval_(interval) {}
    static Interval outwards(const Interval& x) {
        return boost::numeric::widen(x, 2.0 * std::numeric_limits<double>::epsilon());
    }

    Interval interval_;
};

}  // namespace ravnoves::methods
