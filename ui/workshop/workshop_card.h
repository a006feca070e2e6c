#pragma once

#include "shop/job_card.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

/// The job card of the workshop. The first page is what one takes to the machine: bob weight and
/// verdict in large type, the planes as clocks with their holes, lines for the machine's readings.
/// Parts, plugs and take-offs follow.
class WorkshopCard : public JobCard {
  public:
    /// Of the model in its present state when it is painted: the card says what the page says.
    WorkshopCard(const WorkshopModel& model, Words words)
        : JobCard(std::move(words)), model_(model) {}

  protected:
    void draw(CardPage& page) const override;
    QString title() const override;

  private:
    double answer(CardPage& page, double y) const;
    double clocks(CardPage& page, double y) const;
    void drawPlugBeside(CardPage& page, double y) const;
    QString verdictWords() const;

    const WorkshopModel& model_;
};

}  // namespace ravnoves
