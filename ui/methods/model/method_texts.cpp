#include "methods/model/method_texts.h"

#include <QtGlobal>

namespace ravnoves {

std::span<const char* const> methodTexts() {
    // NOLINTBEGIN(bugprone-suspicious-missing-comma): long texts stand on several lines
    static constexpr const char* texts[] = {
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Slider-crank kinematics"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "s, s′, s″ of the piston pin over one turn"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "part of the largest |s|, |s′|, |s″| of the turn"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "s, s′ and s″ at one crank angle"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the closure |crankpin - pin| = L solved by Newton's method, derivatives "
                          "by differences"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Cycle mean and RMS"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "mean of M_ups and its RMS about the mean"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "part of the largest torque of the table + A"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "both numbers, from the table"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "adaptive Gauss-Kronrod quadrature from row to row"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Range of M_ups"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "ΔM_ups, largest less smallest moment over the cycle, at one α"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "the range at one α, the table being prepared"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "Brent's method in every degree between the rows"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Best shaft angle"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "the α with the least range of M_ups"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "range there less the least range, part of the largest torque + A"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "one search over all α, the table being prepared"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "a scan of sampled moments, refined by Brent's method"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Guide of the elastic hinge"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "radius ρ(φ) of the crank's guide over one turn"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "part of the guide's relief"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "ρ at one crank angle"),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "energy of the spring against that of the bars, speeds by differences of positions"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Inertia orders"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "orders 0 to 12 of force and torque of one cylinder"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "part of the largest order, or of m R ω² and m R² ω²"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "all the orders of one cylinder"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the binomial series of the rod's root, term by term"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Motion with a hinge"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "crank angle and speed after whole turns off the design speed"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "rad, or part of the speed, for each turn made"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "one turn of motion"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "speeds by the energy of bars and spring, from differences of positions"),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "Reports print six digits and layouts in balance must come out as zero, which is a "
            "difference of large forces: so nine digits. The exact form needs one square root; a "
            "series of the same cost has three digits at λ = 0.5 and none near locking. The sines "
            "of the nodes are kept, because every cylinder and every turn needs the same ones."),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "The paper's conclusions rest on a mean, so it has to be that of the "
                          "cycle and not of a choice of nodes: nine digits for any table, however "
                          "uneven its rows. The pieces between the rows are integrated exactly; "
                          "after that every angle of the shaft costs three multiplications."),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "The best angle is found from differences of ranges, so nine digits. Nodes miss a peak "
            "between them; the extremum of a line plus a sine is known in closed form, and only "
            "the few intervals that can hold it are solved."),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "The range is the largest of many sinusoids: it has kinks at its minima and several of "
            "them. Sinusoids that bound it from below tell where no better angle can be, so the "
            "best one is found and not just a good one, with fewer evaluations than a scan of 5°."),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "What a guide does lies in its relief, which may be a few micrometres on a radius of a "
            "hundred millimetres: seven digits of the relief. The closed form needs no step and no "
            "start; written without a difference of nearly equal squares it keeps its digits down "
            "to the point where the spring gives out all that it stores."),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "Ripple and energy drift are read off to parts of a million, after up to a thousand "
            "turns: so an error of 1e-7 a turn. Step control finds the few steep places of a turn "
            "by itself; a fixed step that held at λ = 0.95 would be wasted everywhere else."),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "A balanced layout is a sum of orders that cancel; what is left must be rounding, so "
            "eleven digits. No fixed number of points holds that for every λ and K: the order's "
            "decay is known in closed form, and the number of points follows from it."),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "series in λ"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "exact"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "exact, sines by recurrence"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "exact, sines kept"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "node mean, end counted twice"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "trapezoid rule"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Simpson's rule"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Gauss-Legendre, 10 points a panel"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "exact integral of the interpolant"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "largest and smallest node"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "golden section between the rows"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "exact extrema of the pieces"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "scan"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Brent's method"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "steepest descent from a scan of 30°"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "cutting planes"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "closed form as printed"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "closed form"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Euler's method"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Runge-Kutta of order 4"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Dormand-Prince with step control"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Rosenbrock 4, implicit, with step control"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "two-term closed form"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "discrete Fourier transform"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Fourier transform as long as needed"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "exact series"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Runge-Kutta of order 4, fixed step"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "Störmer-Verlet, symplectic"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the terms left out are of the order (λ(1 + K))^2n: three digits at λ = "
                          "0.5 with 4 terms, and no convergence at locking"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "in float the angle itself has seven digits; near locking the error "
                          "grows as the rounding divided by 1 - λ(1 + K)"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "rounding adds up over the points since the last fresh sine"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "near locking the error grows as the rounding divided by 1 - λ(1 + K): "
                          "nine digits are left at 1 - λ(1 + K) = 1e-6"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "never: 720° is 0° once more, so a pure sine gets a mean of A sin α / "
                          "nodes (17.2 N·m in the paper)"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "a peak narrower than the step is seen or missed by chance; the kinks at "
                          "the rows leave order 2"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "on a periodic function its alternate weights make it a trapezoid rule "
                          "of half the nodes and worse"),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "converges slowly over the kinks at the rows; a peak inside one panel is lost"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "exact for the table as it is read; what the engine did between the rows "
                          "is not in the table"),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "an extremum between the nodes is cut off, and a narrow peak is not seen at all"),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "finds one of two extrema between two rows, which long straight pieces have"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "exact for the table as it is read"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "as good as its step, whatever the table"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "finds one of several minima, and on a kink its parabolas do not help"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "stalls at a kink, where the slope does not go to zero but changes sign"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "exact: the bounds prove that no angle is better"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "a difference of nearly equal squares: it loses the digits of a small "
                          "relief or a small preload"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "half of the digits are left where the spring gives out all that it "
                          "stores; beyond there is no guide"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "order 1: the guide does not close after a turn"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "loses its order where ρ comes near ℓ₀/2: the slope is infinite there"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "its steps shrink to nothing where ρ comes near ℓ₀/2"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the same place stops it: what is singular is not stiff"),
        QT_TRANSLATE_NOOP(
            "ravnoves::MethodTexts",
            "leaves λ³/4 in order 2 and all of the higher orders: three digits at λ = 0.25"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "orders above half the points fold onto the low ones: with large λ or K "
                          "a short transform is wrong"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the number of points grows as 1/√(1 - λ(1 + K)); beyond 65536 points it "
                          "says that the accuracy is not reached"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "terms fall as (λ(1 + K))^2n only: near locking thousands are needed, "
                          "and their number grows into the square of the cost"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "its energy drifts steadily: with 90 steps a turn it is wrong after "
                          "thousands of turns, and near λ = 1 at once"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "its energy never drifts, but order 2 leaves it behind in time"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the energy drifts by about the tolerance at every turn: a little less "
                          "than its tolerance promises, but without end"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "float"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "double"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "%1 terms"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "2 terms"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "3 terms"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "4 terms"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "32 terms"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "64 terms"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "fresh every %1"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "never fresh"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "float, never fresh"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "%1 steps"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "24 steps"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "144 steps"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "%1 panels"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "1 panel"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "4 panels"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "72 panels"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "pieces"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "to %1°"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "one start"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "from a scan of %1°"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "free of cancellation"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "%1 points"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "32 points"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "64 points"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "%1 steps a turn"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "crank ratio λ, K = 0"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "relative offset K at λ = 0.265"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "points of one turn at λ = 0.265"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "shaft angle α, the paper's engine"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "shaft angle α, no torque but the shaft's"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "width of the combustion peak"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "rows of a table read by the spline"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "rows of an irregular table"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "amplitude of the shaft's moment, the paper's torque"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "how much better the best of two minima is"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "preload above the least one, part of it"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "stiffness c of the spring"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "stiffness c, preload 1.1 times the least"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "crank speed ω"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "crank ratio λ"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "crank ratio λ, 5 turns"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "start speed, part of the design speed"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "turns"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "N·m"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "N/m"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "rad/s"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the mechanism locks: the crank cannot turn round"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the mechanism is too near locking for the accuracy asked"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "gives no finite number"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "is off by more than numbers can say"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "there is no guide"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "the spring would have to give out more energy than it stores"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "at this speed the turns take no time that a number can hold"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts",
                          "runs into the spring's free length, where the equation is singular"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "nowhere"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "everywhere"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "from %1"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "up to %1"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "at %1"),
        QT_TRANSLATE_NOOP("ravnoves::MethodTexts", "%1 to %2"),
    };
    // NOLINTEND(bugprone-suspicious-missing-comma)
    return texts;
}

}  // namespace ravnoves
