#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "methods/validation/validation.h"

namespace ravnoves::methods {

/// A number as printed.
struct Printed {
    double value = 0.0;
    double last_digit = 1.0;  ///< one unit of its last digit
};

/// Reads "430.39", "-0.01" or an angle "3°20′" (in degrees).
/// @throws std::logic_error for anything else: our fault
Printed read_printed(std::string_view text);

/// The verdict on a claim:
///  - reproduced: ours is within the tolerance of the printed value;
///  - artefact, slip: by_slip is within the tolerance of the printed value and ours is not (else
///    the number is reproduced);
///  - not_derivable: always accepted, nothing can be computed;
///  - given: ours, where there is one, is within the tolerance: it is an input;
///  - anything else, or a number that is not finite: differs.
Verdict decide(Verdict claim, double printed, double tolerance, std::optional<double> ours,
               std::optional<double> by_slip);

/// Collects the rows of one paper.
class PaperRows {
  public:
    explicit PaperRows(std::string_view scene) : scene_(scene) {}

    /// The place of the rows that follow.
    void at(Message place) { place_ = std::move(place); }

    /// @param tolerance  in the row's unit; 0: half a unit of the last printed digit
    void reproduced(Message quantity, std::string unit, std::string_view printed, double ours,
                    Message reason, double tolerance = 0.0) {
        add(Verdict::reproduced, std::move(quantity), std::move(unit), printed, ours, {},
            std::move(reason), tolerance);
    }
    void artefact(Message quantity, std::string unit, std::string_view printed,
                  std::optional<double> ours, double by_slip, Message reason,
                  double tolerance = 0.0) {
        add(Verdict::artefact, std::move(quantity), std::move(unit), printed, ours, by_slip,
            std::move(reason), tolerance);
    }
    void slip(Message quantity, std::string unit, std::string_view printed,
              std::optional<double> ours, double by_slip, Message reason, double tolerance = 0.0) {
        add(Verdict::slip, std::move(quantity), std::move(unit), printed, ours, by_slip,
            std::move(reason), tolerance);
    }
    void not_derivable(Message quantity, std::string unit, std::string_view printed, Message reason,
                       std::optional<double> ours = std::nullopt) {
        add(Verdict::not_derivable, std::move(quantity), std::move(unit), printed, ours, {},
            std::move(reason));
    }
    /// What the paper states and nothing is tested by. @param ours  that the program was told
    void given(Message quantity, std::string unit, std::string_view printed,
               std::optional<double> ours, Message reason = stated()) {
        add(Verdict::given, std::move(quantity), std::move(unit), printed, ours, {},
            std::move(reason));
    }

    std::vector<ValidationRow> take() { return std::move(rows_); }

  private:
    static Message stated();  ///< why a row is given that needs no other words
    void add(Verdict claim, Message quantity, std::string unit, std::string_view printed,
             std::optional<double> ours, std::optional<double> by_slip, Message reason,
             double tolerance = 0.0);

    std::string scene_;
    Message place_;
    std::vector<ValidationRow> rows_;
};

// Places in a paper, and the ends of a range that it gives.
Message in_text(Message place);
Message table(int number);
Message figure(int number);
Message equation(int number);
Message after_equation(int number);
Message lower_end(Text quantity);
Message upper_end(Text quantity);

// The papers, one file each.
std::vector<ValidationRow> validate_gots_klevtsov();
std::vector<ValidationRow> validate_zotov_sviridov();
std::vector<ValidationRow> validate_nazarov();
std::vector<ValidationRow> validate_chainov_vallejo_maldonado();

}  // namespace ravnoves::methods
