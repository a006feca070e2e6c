#pragma once

#include <QObject>
#include <QPolygonF>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/position_study.h"
#include "balance-shaft/speed_study.h"

namespace ravnoves {

class BackgroundJob;
struct CsvFormat;

/// What a range and an RMS over the places of the shaft's axis look like, and what is best. None of
/// it depends on where the axis stands now. Lengths in m, moments in N·m.
struct ShaftMap {
    using Position = balance_shaft::ShaftPosition;
    using Criteria = balance_shaft::PositionCriteria;

    using Place = balance_shaft::BestPosition;
    /// The best α of each centre distance, of all and of those that can be built.
    struct Distances {
        std::vector<double> distance;
        std::vector<Place> range, rms;
        std::vector<std::optional<Place>> rangeBuilt, rmsBuilt;
    };

    balance_shaft::PositionStudy study;
    double view = 0.0;  ///< half of the square that is shown first
    balance_shaft::PositionMap field = {};
    /// Element row × columns + column of a grid over the same rectangle.
    std::vector<balance_shaft::Obstacle> obstacles = {};
    std::size_t obstacleColumns = 0;
    /// Where the shaft cannot be built: closed lines, to be filled by the odd-even rule.
    std::vector<QPolygonF> blocked = {};
    balance_shaft::BestPositions best = {};
    balance_shaft::BestPositions buildable = {};
    std::vector<balance_shaft::FrontPosition> front = {};
    Distances distances = {};
};

/// The map of the places of the shaft's axis: a field of what the criterion does against the engine
/// without a shaft, its lines of equal change, best places, what cannot be built and why.
///
/// The map is made in the background when the input changes; a shaft that moves leaves it as it is.
class ShaftMapModel : public QObject {
    Q_OBJECT

  public:
    using Position = balance_shaft::ShaftPosition;
    using Criteria = balance_shaft::PositionCriteria;

    enum class Criterion { Range, Rms, Both };
    Q_ENUM(Criterion)

    /// A place worth seeing.
    struct Marker {
        Criterion criterion;
        bool isBuildable;
        Position position;
        Criteria criteria;
        QString name;  ///< for the legend
        /// The change at the worst speed, of the place that is least bad over the band of speeds.
        std::optional<double> worst = {};
    };
    /// One line of equal change, m.
    struct Contour {
        double level;  ///< change as a fraction: −0.1 is 10 % less than without a shaft
        std::vector<QPolygonF> lines;
    };

    explicit ShaftMapModel(BalanceShaftModel* model, QObject* parent = nullptr);

    BackgroundJob* job() const { return job_; }
    /// Looks for the place that is least bad over the case's band of speeds, after the map.
    BackgroundJob* bandJob() const { return bandJob_; }
    /// Makes the map anew where it is not that of the input and someone looks.
    void setWatched(bool watched);
    /// What the map shows stays as wide as it is while the shaft is dragged over it.
    void setHeld(bool held);
    /// The map made last, or null; isStale() where a newer one is on the way.
    const ShaftMap* map() const { return map_.get(); }
    bool isStale() const;
    QString trouble() const { return trouble_; }

    Criterion criterion() const { return criterion_; }
    void setCriterion(Criterion criterion);
    /// Share of the range in the weighted sum, 0…1; the RMS has the rest.
    double weight() const { return weight_; }
    void setWeight(double weight);
    /// Change of the criterion against the engine without a shaft, as a fraction; nothing where
    /// that has none.
    std::optional<double> change(const Criteria& criteria) const;
    QString criterionName() const;

    /// Of the field's elements, row × columns + column.
    const std::vector<double>& changes() const { return changes_; }
    /// Where the colours change: ascending, with 0 among them.
    const std::vector<double>& levels() const { return levels_; }
    const std::vector<Contour>& contours() const { return contours_; }

    const std::vector<Marker>& markers() const { return markers_; }
    /// The best place of the criterion that can be built, of all where none can; null where the
    /// map is not there yet.
    const Marker* best() const;
    /// Says what it is, and what a place that cannot be built would gain.
    QString bestText() const;
    /// One place in words: l, α, range, RMS, change, size, and why it cannot be built.
    /// @param decimals  of l and α; 2 name a place of `shortened()`
    QString placeText(const Position& position, int decimals = 2) const;
    /// The same but for the reason, a line each.
    QStringList placeLines(const Position& position, int decimals = 2) const;
    /// What the place gives here against what it gives in another map, the difference of each.
    QString againstText(const ShaftMapModel& other, const QString& name,
                        const Position& position) const;
    /// What is best in another map by the criterion of this one, and this one's best against it.
    QString bestAgainstText(const ShaftMapModel& other, const QString& name) const;
    QString reason(const Position& position) const;
    QString markerText(const Marker& marker) const;

    Position present() const;
    bool isBuildable(const Position& position) const;
    /// The best by a criterion of the places nearby whose l and α are whole 0.01 mm and 0.01°,
    /// among those that can be built as the place itself can, or cannot; the place where there is
    /// none.
    /// @param keepsDistance  l is whole already and stays
    Position shortened(const Position& exact, Criterion by, bool keepsDistance = false) const;
    /// Whether the shaft is at best().
    bool isAtBest() const;
    /// Moves the shaft's axis; moves that follow each other are one step of the history.
    void moveTo(const Position& position);
    /// The same by a hand on a screen, which is no finer than 0.1 µm and 0.0001°.
    void dragTo(const Position& position);
    /// Moves it as a step of its own.
    void goTo(const Position& position);
    void goToBest();
    void setDistance(double metres);
    /// Goes to this centre distance, at the best α of the criterion there: of those that can be
    /// built where there are any.
    void goToDistance(double metres);
    double largestDistance() const;  ///< that a slider should reach, m

    /// All three criteria, changes and obstacles over a grid of places.
    QString fieldCsv(const CsvFormat& csv) const;

  Q_SIGNALS:
    /// The map, the criterion or what follows them is new.
    void mapChanged();
    /// A newer map is on the way, or is no longer.
    void staleChanged();
    void moved();

  private:
    /// A shaft outside of what is shown needs a larger map.
    void follow(bool mayShrink = false);
    void start();
    void startBand();
    void addBandMarker();
    void showMap();
    void showCriterion();
    std::vector<double> chooseLevels() const;
    double rangeShare() const;
    double rangeWeight() const;
    double weighted(double range, double rms) const;
    double valueOf(const Criteria& criteria, Criterion by) const;
    /// By the criterion, with its change.
    QString valueText(const Criteria& criteria) const;
    void placeShaft(double centreDistance, double shaftAngle);
    void addMarker(Criterion criterion, bool isBuildable,
                   const std::optional<balance_shaft::BestPosition>& best);

    BalanceShaftModel* model_;
    BackgroundJob* job_;
    BackgroundJob* bandJob_;
    bool watched_ = false;
    bool held_ = false;
    std::shared_ptr<const ShaftMap> map_;
    std::optional<balance_shaft::Input> mapped_;  ///< what the map is made of, or will be
    /// Least bad over the band, by range and by RMS.
    struct BandPlace {
        balance_shaft::SpeedStudy::LeastBadPlace place;
        bool isBuildable;
    };
    std::optional<BandPlace> bandRange_;
    std::optional<BandPlace> bandRms_;
    QString trouble_;
    Criterion criterion_ = Criterion::Range;
    double weight_ = 0.5;
    std::vector<double> changes_;
    std::vector<double> levels_;
    std::vector<Contour> contours_;
    std::vector<Marker> markers_;
};

}  // namespace ravnoves
