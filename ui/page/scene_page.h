#pragma once

#include <QAction>
#include <QList>
#include <QWidget>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "model/scene_model.h"

namespace ravnoves {

/// One page of the program: thin widgets over a model.
class ScenePage : public QWidget {
    Q_OBJECT

  public:
    explicit ScenePage(QWidget* parent = nullptr);
    ~ScenePage() override;

    virtual SceneModel* model() = 0;
    /// Actions for the toolbar and the Scene menu, in order; null entries are separators.
    virtual QList<QAction*> sceneActions() { return {}; }
    /// The results as tab-separated text and as CSV.
    virtual QString resultsAsText() const;
    virtual QString resultsAsCsv() const;
    /// Called when the page comes to the front or leaves it (animations stop).
    virtual void setActive(bool active);
    /// Every plot of the page shows all it has.
    void resetZoom();
    /// True while something that the page shows is still computed in the background.
    bool isBusy() const;
    /// Something beside the page may be computed for it.
    void addBusy(std::function<bool()> isBusy) { busy_.push_back(std::move(isBusy)); }
    /// Asks what to do with unsaved changes where the page keeps them in a place of its own rather
    /// than in case files. @return false where the user wants to stay; nothing: the window asks
    virtual std::optional<bool> askToSave() { return std::nullopt; }
    /// Saves a case without a file there, with the page's questions. @return false where the user
    /// cancels or saving fails; empty: the window prompts for a file
    virtual std::optional<bool> saveInPlace() { return std::nullopt; }
    /// The effect of saveInPlace(), for a tip; empty where the window prompts for a file.
    virtual QString savingTip() const { return {}; }

    /// How to find the other open pages, the one in front last first. Called once, after the page
    /// was made.
    void setOthers(std::function<QList<ScenePage*>()> others) { others_ = std::move(others); }

    /// Lets the model go: the page is made again over it, in another language or with other units.
    SceneModel* letGo();
    /// The tabs in front, by the names of their pages.
    QStringList shownTabs() const;
    void showTabs(const QStringList& names);

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);
    /// Another page, or a question about this one, wants it in front.
    void frontWanted();

  protected:
    /// The model that a page before this one has left, else a new one.
    template <typename Model, typename... Arguments>
    Model* adopt(SceneModel* kept, Arguments&&... arguments) {
        if (kept == nullptr) {
            kept = new Model(std::forward<Arguments>(arguments)..., this);
        }
        kept->setParent(this);
        followDrags(kept);
        return static_cast<Model*>(kept);
    }

    QList<ScenePage*> others() const { return others_ ? others_() : QList<ScenePage*>(); }

    bool event(QEvent* event) override;

  private:
    /// Axes are fixed during a drag, and follow the content afterwards.
    void followDrags(SceneModel* model);

    std::function<QList<ScenePage*>()> others_;
    std::vector<std::function<bool()>> busy_;
};

}  // namespace ravnoves
