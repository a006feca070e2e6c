#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "case-file/json_fwd.h"
#include "case-file/message.h"

/// The angle that holds best when the inputs scatter, beside the one that is best of the inputs as
/// they are.
namespace ravnoves::studies {

struct Problem;

/// What an angle of the input, chosen to make a value least, does to its 95th percentile over the
/// samples: "robust best α". Every angle meets the same samples, so that angles compare by far
/// better than each is known.
struct RobustBest {
    static constexpr double percent = 95.0;
    /// Of the samples, so many at least can be built at the robust angle, where that is so
    /// anywhere.
    static constexpr double least_buildable = percent / 100.0;
    struct Place {
        double angle = 0.0;  ///< degrees, 0…360
        double angle_error = 0.0;
        double percentile = 0.0;  ///< of the value, in the unit of its key
        double percentile_error = 0.0;
        std::optional<double> nominal{};  ///< the value of the inputs as they are
        /// Share of the samples that can be built at it; nothing where that cannot be told.
        std::optional<double> buildable{};
        friend bool operator==(const Place&, const Place&) = default;
    };
    std::string input;  ///< JSON pointers of angle and value
    std::string value;
    std::uint64_t samples = 0;
    std::uint64_t refused = 0;  ///< of them, at one of the angles that were tried, or more
    /// Of the angles that can be built, of the inputs as they are and in `least_buildable` of the
    /// samples, or where no angle can, in as many as anywhere; empty with a reason.
    std::optional<Place> robust{};
    Message reason{};
    /// The scene's own best angle; it is what it is, without an error.
    std::optional<Place> nominal{};
    /// Percentile at the nominal best less that at the robust one, with its standard error, which
    /// is far below theirs; of both places.
    double gain = 0.0;
    double gain_error = 0.0;
    friend bool operator==(const RobustBest&, const RobustBest&) = default;
};

/// Whether the study watches what the angle is chosen for.
bool asks_for_robust_best(const Problem& problem);

/// The least 95th percentile over all angles that RobustBest::robust may have, by the study's first
/// 2048 samples (Sobol points where it has none): the percentile moves with the angle by no more
/// than the steepest sample does, so stretches are quartered until none can hold less, up to a
/// twentieth of its standard error or 0.1°; about the best the angles are 0.00125° apart. Standard
/// errors by the jackknife, sixteen groups of samples left out in turn.
/// @param threads  0: as many as there are cores
/// @param goes_on  asked now and then; false stops the work
/// @return nothing where the scene chooses no angle, the study is a grid, or it was stopped
std::optional<RobustBest> find_robust_best(const Problem& problem, int threads = 0,
                                           const std::function<bool()>& goes_on = {});

Json write_robust_best(const RobustBest& best);
/// @throws Json::exception where it is not what write_robust_best() writes
RobustBest read_robust_best(const Json& json);

}  // namespace ravnoves::studies
