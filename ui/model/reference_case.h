#pragma once

#include <QObject>
#include <memory>
#include <string>

namespace ravnoves {

class SceneModel;

/// The variant that a case is compared with, solved, as a model of its own with the same parts.
/// Null while the case has no reference.
class ReferenceCase : public QObject {
    Q_OBJECT

  public:
    /// Belongs to the model of the case and follows it.
    explicit ReferenceCase(SceneModel* present);
    ~ReferenceCase() override;

    /// Null: none.
    const SceneModel* model() const { return model_.get(); }
    SceneModel* model() { return model_.get(); }
    QString name() const { return name_; }

  Q_SIGNALS:
    /// Another one, or none, or it shows something else.
    void changed();
    /// Its message for the user.
    void said(const QString& text);

  private:
    void follow();
    void takeView();

    SceneModel* present_;
    std::unique_ptr<SceneModel> model_;
    std::string shown_;  ///< its input
    QString name_;
};

}  // namespace ravnoves
