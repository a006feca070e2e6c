#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"
#include "studies/model/band_samples.h"

namespace ravnoves {

class SceneModel;

/// The numbers of some parts of a case, points of curves and cells of tables, in one row, and the
/// same of other inputs.
class PartNumbers {
  public:
    PartNumbers(const SceneModel& model, const std::vector<std::string_view>& ids);

    const std::vector<double>& nominal() const { return nominal_; }
    /// 360 for an angle; else 0.
    const std::vector<double>& periods() const { return periods_; }
    /// Of another input; not a number where it has none.
    std::vector<double> of(const SceneModel& sample) const;
    /// Their spreads, part by part.
    std::map<std::string, PartSpread, std::less<>> spreads(const BandSamples::Sides& sides,
                                                           const QString& how) const;

  private:
    struct Shown {
        std::string id;
        std::size_t from = 0;  ///< the first of its numbers
        Content content;
    };

    void add(const Figure& figure);
    void add(const Results& results);
    PartSpread spreadOf(const Figure& figure, std::size_t from,
                        const BandSamples::Sides& sides) const;
    PartSpread spreadOf(const Results& results, std::size_t from,
                        const BandSamples::Sides& sides) const;

    std::vector<Shown> parts_;
    std::vector<double> nominal_;
    std::vector<double> periods_;
};

}  // namespace ravnoves
