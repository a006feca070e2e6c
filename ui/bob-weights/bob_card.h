#pragma once

#include "bob-weights/input.h"
#include "bob-weights/result.h"
#include "workshop/job_card.h"

namespace ravnoves {

/// The job card of a bob weight: the head of the job, the bob weight line by line, readings, holes
/// and what remains, room for the machine's last readings and for signatures.
class BobCard : public JobCard {
  public:
    /// @param solution  what the page shows of the input: the card withholds what it withholds
    BobCard(bob_weights::Input input, bob_weights::Result solution, Words words);

  protected:
    void draw(CardPage& page) const override;
    QString title() const override;

  private:
    bob_weights::Input input_;
    bob_weights::Result solution_;
};

}  // namespace ravnoves
