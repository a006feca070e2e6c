#pragma once

#include <QPageSize>

#include "paper/paper.h"
#include "workshop/model/workshop_model.h"

class QWidget;

namespace ravnoves {

/// The job card. The first page is what one takes to the machine: bob weight and verdict in large
/// type, the planes as clocks with their holes, lines for the machine's readings. Parts, plugs and
/// take-offs follow.
/// @param rejected  entries that the form rejects: the card notes that it has the values before
/// them
/// @param ofResult  the ones that the answer depends on: the card has none
Paper jobCard(const WorkshopModel& model, const Words& words, const QStringList& rejected = {},
              const QStringList& ofResult = {});

/// The paper that a card was printed on last, else the usual one of the desktop's country.
QPageSize cardPaper();
/// Keeps the paper of a device, which the user may have changed in a dialog, for the next card.
void keepCardPaper(const QPagedPaintDevice& device);

/// Lets the user type the name of the shop, which all cards have.
void askShopName(QWidget* parent);

}  // namespace ravnoves
