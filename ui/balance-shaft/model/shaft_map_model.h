#pragma once

#include <QObject>
#include <QPolygonF>
#include <QStringList>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/change_contours.h"
#include "balance-shaft/position_study.h"

namespace ravnoves {

class BackgroundJob;
struct CsvFormat;

/// The range and RMS over the places of the shaft's axis, and the best ones, independent of the
/// present axis. Lengths in m, moments in N·m.
struct ShaftMap {
    using Position = balance_shaft::ShaftPosition;
    using Criteria = balance_shaft::PositionCriteria;

    /// Half of the square to show: it contains the best places and this l, with room around.
    double viewFor(double centreDistance) const;

    balance_shaft::PositionStudy study;
    double view = 0.0;  ///< half of the square that is shown first
    balance_shaft::PositionMap field = {};
    /// Infeasible places: closed lines, to be filled by the odd-even rule.
    std::vector<QPolygonF> blocked = {};
    balance_shaft::BestPositions best = {};
    balance_shaft::BestPositions buildable = {};
    /// Of each criterion the smallest place that is at most a hundredth worse.
    std::optional<balance_shaft::BestPosition> smallRange = {}, smallRms = {};
    std::vector<balance_shaft::BestPosition> front = {};
};

/// The map of the places of the shaft's axis: the latest map (ShaftMap), its values by the
/// criterion, places worth seeing, the moves of the axis over it, and their texts.
///
/// The map is made in the background when the input changes; a moving shaft does not change it.
class ShaftMapModel : public QObject {
    Q_OBJECT

  public:
    using Position = ShaftMap::Position;
    using Criteria = ShaftMap::Criteria;
    using Criterion = BalanceShaftModel::Criterion;

    /// A place worth seeing.
    struct Marker {
        Criterion criterion;
        bool isBuildable;
        Position position;
        Criteria criteria;

        QString name() const;  ///< for the legend
    };

    /// Belongs to the model.
    explicit ShaftMapModel(BalanceShaftModel* model);

    BackgroundJob* job() const { return job_; }
    /// Makes the map again where the input has changed. Its extent is kept while a slider or a hand
    /// moves the shaft.
    void need();
    void setHeld(bool held);
    /// The map made last, or null; isStale() where a newer one is on the way.
    const ShaftMap* map() const { return map_.get(); }
    bool isStale() const;

    Criterion criterion() const { return model_->criterion(); }
    bool byRange() const { return model_->byRange(); }
    /// The model's criterion is another.
    void showCriterion();
    /// Change of the criterion against the engine without a shaft, as a fraction: −0.1 is 10 %
    /// less; nothing where that has none.
    std::optional<double> change(const Criteria& criteria) const;

    /// Over x and y in mm; empty while there is no map, and where no change() is known.
    const ChangeContours& field() const { return field_; }

    const std::vector<Marker>& markers() const { return markers_; }
    /// The smallest feasible place that is at most a hundredth worse than the best by the
    /// criterion; the best of all where nothing fits; null before there is a map.
    const Marker* best() const;

    Position present() const;
    bool isBuildable(const Position& position) const;
    /// The best by a criterion of the places nearby whose l and α are whole 0.01 mm and 0.01° and
    /// that are as feasible as the place itself; else the place.
    Position shortened(const Position& exact, Criterion by) const;
    /// Whether the shaft is at best(), or at a feasible place that is no worse.
    bool isAtBest() const;
    /// How finely the shaft's axis is moved: parts of a millimetre and of a degree.
    enum Parts : std::uint64_t {
        Snapped = 2,             ///< by the pointer
        Exact = 100'000'000'000  ///< keeps short numbers
    };
    /// Moves it; moves that follow each other are one step of the history.
    void moveTo(const Position& position, Parts parts = Exact);
    /// Moves it as a step of its own.
    void goTo(const Position& position, Parts parts = Exact);
    void goToBest();
    double largestDistance() const;  ///< that a slider should reach, m

    /// The best place, and the gain of an infeasible one; or why there is no map.
    QString answer() const;
    /// One place: l, α, range, RMS, change, size, and its obstacle if it is infeasible.
    /// @param decimals  of l and α; 2 name a place of shortened()
    QString placeText(const Position& position, int decimals = 2) const;
    /// The same but for the reason, a line each.
    QStringList placeLines(const Position& position, int decimals = 2) const;
    /// Why the shaft is infeasible there; empty where it fits.
    QString reasonAt(const Position& position) const;
    /// Range, RMS and feasibility over a grid of places.
    QString fieldCsv(const CsvFormat& format) const;

  Q_SIGNALS:
    /// The map, the criterion or what follows them is new.
    void mapChanged();
    /// A newer map is on the way, or is no longer.
    void staleChanged();
    /// The shaft is elsewhere, or the case is another.
    void moved();

  private:
    /// The shaft is within the extent shown, and this is not much too wide.
    bool fits() const;
    void start();
    void showMap();
    void addMarker(Criterion criterion, bool isBuildable,
                   const std::optional<balance_shaft::BestPosition>& best);

    BalanceShaftModel* model_;
    BackgroundJob* job_;
    bool held_ = false;
    std::shared_ptr<const ShaftMap> map_;
    std::optional<balance_shaft::Input> mapped_;  ///< what the map is made of, or will be
    int seen_ = -1;                               ///< solutions, at the last look
    bool isMapped_ = false;                       ///< the case was that, at the last look
    QString trouble_;                             ///< why there is no map, and none is on the way
    Position seenAt_;                             ///< of the shaft, when it last moved
    ChangeContours field_;
    std::vector<Marker> markers_;
};

}  // namespace ravnoves
