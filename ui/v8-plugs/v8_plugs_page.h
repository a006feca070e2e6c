#pragma once

#include "workshop/workshop_page.h"

namespace ravnoves {

class PlugsAnswer;
class V8PlugsModel;

/// The V-8 page of the workshop: to the right the answer with its options, bob weights, plug and
/// plots.
class V8PlugsPage : public WorkshopPage {
    Q_OBJECT

  public:
    explicit V8PlugsPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);
    V8PlugsPage(const QString& journalPath, QWidget* parent, SceneModel* kept = nullptr);

    SceneModel* model() override;
    V8PlugsModel* viewModel() { return model_; }
    void setActive(bool active) override;

  protected:
    JobDesk* desk() const override;
    std::unique_ptr<JobCard> card() override;
    void emptySheet() override;
    QString carriedOver() const override;
    ListedJob listed(const Words& words, const JournalJob& job) const override;
    void showRefused(const QStringList& refused) override;

  private:
    V8PlugsModel* model_;
    PlugsAnswer* answer_ = nullptr;
};

}  // namespace ravnoves
