#pragma once

#include <array>

#include "v8-plugs/input.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/solver.h"
#include "workshop/card_page.h"
#include "workshop/model/words.h"

namespace ravnoves {

/// Paints the sections of the job card one below the other. The lower part (machine, signatures)
/// has its fixed place on the first sheet; what the sections above leave no room for goes on on the
/// next.
class PlugsCardPainter {
  public:
    PlugsCardPainter(CardPage& sheet, const v8_plugs::Input& input,
                     const v8_plugs::Result& solution, const Words& words, const QString& refused,
                     const QString& otherRefused)
        : sheet_(sheet),
          input_(input),
          solution_(solution),
          words_(words),
          refused_(refused),
          otherRefused_(otherRefused) {}

    void paint();

  private:
    // Each section begins at y (mm) and returns where it ends.
    double head(double y);
    double answer(double y);
    double inputs(double y);
    double options(double y);
    double bobWeights(double y);
    double weighIn(double y);
    double remarks(double y, double points);
    double heightOfRemarks(double points) const;
    /// What is doubtful, and all else that is to be said.
    std::array<QString, 2> remarkTexts() const;
    double machine(double y);
    void foot(double machineTop);

    double engineTable(double y, double width);
    void changesTable(double x, double y, double width);
    double bobWeightTable(double y);
    void plug(double x, double y, double w, double h);

    QString grams(double mass, int decimals = 2) const;
    QString unitGram() const { return words_.unit(units::gram); }
    QString unitUnbalance() const { return words_.unit(units::gram_mm); }

    static constexpr double left = CardPage::left;
    static constexpr double full = CardPage::full;
    static constexpr double right = CardPage::right;
    inline static const QString missing = QStringLiteral("—");

    CardPage& sheet_;
    const v8_plugs::Input& input_;
    const v8_plugs::Result& solution_;
    const Words& words_;
    const QString refused_;  ///< that the answer is of values before refused entries; may be empty
    const QString otherRefused_;  ///< entries that the answer does not depend on; may be empty
};

}  // namespace ravnoves
