#include "v8-plugs/plugs_card.h"

#include "v8-plugs/plugs_card_painter.h"

namespace ravnoves {

PlugsCard::PlugsCard(v8_plugs::Input input, v8_plugs::Result solution, Words words)
    : JobCard(std::move(words)), input_(std::move(input)), solution_(std::move(solution)) {}

void PlugsCard::draw(CardPage& page) const {
    PlugsCardPainter(page, input_, solution_, words(), refusedText(), otherRefusedText()).paint();
}

QString PlugsCard::title() const {
    return words().translate("JobCard", "Job card: crankpin plugs and bob weights") +
           QLatin1Char(' ') + QString::fromStdString(input_.job.engine_number);
}

}  // namespace ravnoves
