#pragma once

#include <QCoreApplication>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/model/balance_shaft_model.h"

namespace ravnoves {

/// The forces on the engine without and with a shaft, and what a gear fitted some teeth out, and
/// its play, do.
class ForcesModel {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ForcesModel)

  public:
    /// Where the tip of the force runs, kN.
    struct Loci {
        // A picture that holds them all, with some room.
        double across = 0.0;  ///< half its width
        double lowest = 0.0;
        double highest = 0.0;
        balance_shaft::ForceLocus first;
        balance_shaft::ForceLocus both;  ///< first and second order
        balance_shaft::ForceLocus withShaft;
    };

    explicit ForcesModel(const BalanceShaftModel* model) : model_(model) {}

    Loci loci() const;
    ResultRows forceRows() const;

    balance_shaft::GearError gearError() const;
    static ResultRows gearRows(const balance_shaft::GearError& error);

  private:
    const BalanceShaftModel* model_;
};

}  // namespace ravnoves
