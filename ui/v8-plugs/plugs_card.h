#pragma once

#include "v8-plugs/input.h"
#include "v8-plugs/result.h"
#include "workshop/job_card.h"

namespace ravnoves {

/// The V-8's job card: the head of the job, the inputs, the answer, the plug, the bob weights line
/// by line, the machine's limits and room for its readings and for signatures.
class PlugsCard : public JobCard {
  public:
    /// @param solution  what the page shows of the input: the card withholds what it withholds
    PlugsCard(v8_plugs::Input input, v8_plugs::Result solution, Words words);

  protected:
    void draw(CardPage& page) const override;
    QString title() const override;

  private:
    v8_plugs::Input input_;
    v8_plugs::Result solution_;
};

}  // namespace ravnoves
