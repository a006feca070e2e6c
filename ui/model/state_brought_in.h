#pragma once

#include <QObject>

namespace ravnoves {

class SceneModel;

/// Says that a model holds another state as a whole: undone, redone, loaded, a preset, a variant.
/// Unlike a change of one value, that ends what was typed and refused in any field of the model.
class StateBroughtIn : public QObject {
    Q_OBJECT

  public:
    /// The one of a model.
    static StateBroughtIn& of(SceneModel* model);

  Q_SIGNALS:
    /// The model holds it already, and has said so.
    void done();

  private:
    using QObject::QObject;
};

}  // namespace ravnoves
