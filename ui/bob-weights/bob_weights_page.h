#pragma once

#include "workshop/workshop_page.h"

namespace ravnoves {

class BobAnswer;
class BobWeightsModel;

/// The page of bob weights for any engine.
class BobWeightsPage : public WorkshopPage {
    Q_OBJECT

  public:
    explicit BobWeightsPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);
    BobWeightsPage(const QString& journalPath, QWidget* parent, SceneModel* kept = nullptr);

    SceneModel* model() override;
    BobWeightsModel* viewModel() { return model_; }

  protected:
    JobDesk* desk() const override;
    std::unique_ptr<JobCard> card() override;
    void emptySheet() override;
    QString carriedOver() const override;
    ListedJob listed(const Words& words, const JournalJob& job) const override;
    void showRefused(const QStringList& refused) override;

  private:
    BobWeightsModel* model_;
    BobAnswer* answer_ = nullptr;
};

}  // namespace ravnoves
