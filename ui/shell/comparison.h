#pragma once

#include <QObject>
#include <memory>

namespace ravnoves {

class ScenePage;

/// Shows a page's present input against the variant that its model has as reference.
///
/// A second page of the same scene, which nobody sees, holds the variant's input; each plot of the
/// page takes the curves of its counterpart there as ghosts, so do pictures that compare, each
/// table its cells for differences. So no scene needs a line for it, and nothing is there while
/// there is no reference.
class Comparison : public QObject {
    Q_OBJECT

  public:
    /// Belongs to the page and follows its model.
    explicit Comparison(ScenePage* page);
    ~Comparison() override;

    /// The page that holds the reference; null while there is none.
    ScenePage* twin() const { return twin_.get(); }
    /// Why the reference cannot be shown; empty where it can, or where there is none.
    QString trouble() const { return trouble_; }

  private:
    void showReference();
    void takeView();
    void connectParts(const QString& name);
    /// Fills also what is computed only while it is seen.
    void fill();

    ScenePage* page_;
    std::unique_ptr<ScenePage> twin_;
    std::string shown_;  ///< the input that the twin holds
    QString trouble_;
    bool stale_ = false;  ///< the twin's model has changed since it was filled
};

}  // namespace ravnoves
