#pragma once

#include <QObject>
#include <optional>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/relieved_shaft.h"

namespace ravnoves {

/// The balance shaft as a round bar with a segment milled away (the paper's Fig. 5) for the
/// unbalance m₁ ρ₁ of the page: which of its sizes are given, which one is found, and its drawing.
class RelievedShaftModel : public QObject {
    Q_OBJECT

  public:
    /// Which size follows from the other two.
    enum class Sized { Depth, Length, Diameter, None };
    Q_ENUM(Sized)
    using Size = std::optional<double> balance_shaft::RelievedShaftSizes::*;

    explicit RelievedShaftModel(BalanceShaftModel* model, QObject* parent = nullptr);

    balance_shaft::RelievedShaft shaft() const { return model_->relievedShaft(); }
    balance_shaft::RelievedShaftSizes sizes() const;
    Sized sized() const;
    /// The computed sizes become given ones.
    void choose(Sized sized);
    /// A size in m, given or found; empty without one.
    std::optional<double> sizeOf(Size size) const;
    bool isGiven(Size size) const { return (sizes().*size).has_value(); }
    void setSize(const Field& field, Size size, double metres);
    void setDensity(double density);

    // The results shown of any shaft.
    static Results results(const balance_shaft::RelievedShaft& shaft);
    static QString verdict(const balance_shaft::RelievedShaft& shaft);
    /// Section and side view, real size.
    /// @return an empty string, or what went wrong
    QString exportDxf(const QString& path) const;

  private:
    BalanceShaftModel* model_;
};

}  // namespace ravnoves
