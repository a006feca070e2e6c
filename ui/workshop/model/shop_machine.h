#pragma once

#include <QObject>

#include "workshop/input.h"

namespace ravnoves {

/// The balancing machine as the shop has set it up: new jobs begin with it.
class ShopMachine : public QObject {
    Q_OBJECT

  public:
    static ShopMachine& instance();

    workshop::Machine kept() const;
    void keep(const workshop::Machine& machine);

  Q_SIGNALS:
    void changed(const ravnoves::workshop::Machine& before);
};

}  // namespace ravnoves
