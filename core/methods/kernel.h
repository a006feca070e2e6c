#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/message.h"

/// Speed against accuracy: every method that could compute a quantity of the scenes, with its
/// error against 50 digits, its cost, and where it fails.
namespace ravnoves::methods {

/// One setting of a method: a number of nodes, a step, a tolerance…
struct Setting {
    Message label;       ///< as the table shows it: "15°", "64 points", "float"
    double value = 0.0;  ///< its number; the method defines the meaning
};

/// Settings whose number is in the label: "64 points".
inline Setting counted(Text label, double value) {
    return {Message(label, value), value};
}
std::vector<Setting> counted(Text label, std::initializer_list<double> values);

/// What a method says of itself.
struct MethodInfo {
    std::string id;                 ///< "trapezoid"
    Text title;                     ///< "trapezoid rule"
    Text limits;                    ///< where it stops being trustworthy and why, as a sentence
    std::vector<Setting> settings;  ///< the finest last: it is in the stability map
    /// True where Setting::value counts nodes, steps or terms, so that an order of convergence
    /// −d log(error) / d log(value) can be found.
    bool has_order = false;
};

/// How values are spread over a sweep.
enum class Spacing { linear, logarithmic };

/// A hard parameter: one number that carries a kernel's problems from easy to hard.
struct SweepInfo {
    std::string id;  ///< "lambda"
    Text title;      ///< "crank ratio λ"
    Unit unit;       ///< that its values are in
    double from = 0.0;
    double to = 1.0;
    Spacing spacing = Spacing::linear;
    /// The part of from…to in which the scene answers for its tolerance.
    double scene_from = 0.0;
    double scene_to = 1.0;
    double present = 0.0;     ///< the value of the scene's preset
    std::size_t points = 25;  ///< of a stability curve

    /// The value at a place 0…1 of the sweep, spread by `spacing`. Places outside 0…1 are its ends.
    double at(double place) const;
    /// The place of a value, 0…1; values outside the sweep are at its ends.
    double place(double value) const;
    /// n ≥ 2 values from `from` to `to`, spread by `spacing`; ends included.
    std::vector<double> values(std::size_t n) const;
    /// True where a value can be on a logarithmic axis.
    bool logarithmic() const { return spacing == Spacing::logarithmic; }
};

/// The method and setting that compute a kernel's quantity in its scene, and how far the result may
/// be off. Tests fail where the method exceeds the tolerance, or where a cheaper one would be
/// within it.
struct MethodChoice {
    std::string_view scene;    ///< of the case files
    std::string_view method;   ///< id of the method
    std::string_view setting;  ///< label of its setting
    double tolerance;          ///< in the kernel's measure of error
    Text reason;               ///< why this tolerance and this method: sentences for the page
};

/// Runs a method on the problem it was prepared for and writes the outputs.
/// @return empty, or why there are no numbers, as a clause ("the mechanism locks")
using Run = std::function<Message(std::span<double> out)>;

/// One problem of a kernel, for one thread at a time.
struct Problem {
    std::size_t outputs;
    /// How many evaluations one run makes; times are given per evaluation.
    double evaluations;
    /// The method made ready for this problem: what the scene prepares once is prepared here. The
    /// run lives no longer than the problem.
    std::function<Run(std::size_t method, std::size_t setting)> prepare;
    /// Largest error of the outputs against 50 digits, in the kernel's measure. The reference is
    /// made when it is first asked for.
    std::function<double(std::span<const double> out)> error;
};

/// A quantity that scenes compute, with all the methods that could compute it.
struct Kernel {
    std::string id;      ///< "slider-crank"
    Text title;          ///< "Slider-crank kinematics"
    Text quantity;       ///< the computed quantity
    Text error_measure;  ///< what the error is relative to
    Text evaluation;     ///< what one evaluation is, for the time axis
    Text reference;      ///< how the 50 digits come about, by none of the scene's formulas
    MethodChoice choice;
    std::vector<MethodInfo> methods;
    std::vector<SweepInfo> sweeps;  ///< the first is the one that charts begin with
    std::function<Problem(std::size_t sweep, double value)> problem;

    std::size_t find_method(std::string_view id) const;  ///< that must be there
    std::size_t find_setting(std::size_t method, std::string_view label) const;  ///< likewise
    std::size_t chosen_method() const { return find_method(choice.method); }
    std::size_t chosen_setting() const { return find_setting(chosen_method(), choice.setting); }
};

/// All kernels: what the page, the command line, the benchmark and the tests read.
const std::vector<Kernel>& kernels();
/// @return null for an unknown id
const Kernel* find_kernel(std::string_view id);

/// What became of one run.
struct Result {
    double error = 0.0;  ///< in the kernel's measure; meaningless where rejected
    Message rejection;   ///< why there are no numbers; empty where there are
    bool rejected() const { return !rejection.empty(); }
};

/// Runs a method once and compares. Outputs that are not finite are a rejection too, so that
/// nothing but numbers reaches a chart.
Result evaluate(const Problem& problem, std::size_t method, std::size_t setting);

}  // namespace ravnoves::methods
