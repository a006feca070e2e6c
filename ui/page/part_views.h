#pragma once

#include <vector>

#include "model/part.h"
#include "model/scene_model.h"
#include "plot/plot_view.h"
#include "widgets/answer_label.h"
#include "widgets/result_table.h"

namespace ravnoves {

/// Makes a widget show a part of a model, while it is visible: one behind another tab is empty
/// until it comes to the front. Below it is the same part of the reference.
class PartView {
  public:
    /// @param id  of the part; of the model's parts()
    PartView(SceneModel* model, std::string_view id, QWidget* widget);
    virtual ~PartView() = default;
    PartView(const PartView&) = delete;
    PartView& operator=(const PartView&) = delete;

    std::string_view id() const { return id_; }
    const QWidget* widget() const { return widget_; }
    /// Shows what the part is now, seen or not.
    void make();
    /// The effect of the tolerances on the content.
    virtual void showSpread(const PartSpread& spread) = 0;
    /// The content has changed: its spread is being computed, or it has none.
    virtual void clearSpread(bool another) = 0;
    /// All below a widget that are seen, or all.
    static std::vector<PartView*> below(const QWidget& page, bool seenAlone);
    SceneModel* partModel() const { return model_; }

  protected:
    /// Its widget came to the front.
    void shown();
    virtual void showPart(const Content& content) = 0;
    /// Nothing: there is no reference.
    virtual void showReference(const Content* content, const QString& name) = 0;
    bool hidesWhereEmpty_ = false;  ///< the content says whether the widget is visible

  private:
    bool isSeen() const { return hidesWhereEmpty_ || widget_->isVisibleTo(widget_->window()); }
    void outdate(bool ofReference);

    SceneModel* model_;
    std::string_view id_;
    QWidget* widget_;
    bool isStale_ = true;
    bool isReferenceStale_ = true;
};

/// A plot of a figure.
class PartPlot : public PlotView, public PartView {
    Q_OBJECT

  public:
    PartPlot(SceneModel* model, std::string_view id, QWidget* parent = nullptr);

    /// It shows more than a figure has: none but itself can be drawn.
    virtual bool isDrawing() const { return false; }
    void showSpread(const PartSpread& spread) override { setSpreads(spread.curves); }
    void clearSpread(bool /*another*/) override { setSpreads({}); }

  protected:
    void showEvent(QShowEvent* event) override;
    void showPart(const Content& content) override;
    void showReference(const Content* content, const QString& name) override;
};

/// The answer below a widget: its tables as CSV, or as tab-separated text with its lines.
QString answerOf(const QWidget& page, bool asCsv);

/// What shows a part below a widget, and where that is a plot; null without one.
PartView* partView(const QWidget& page, std::string_view id);
PartPlot* partPlot(const QWidget& page, std::string_view id);

/// A table of results.
class PartTable : public ResultTable, public PartView {
    Q_OBJECT

  public:
    /// @param name  of the content, for screen readers
    PartTable(SceneModel* model, std::string_view id, const QString& name,
              QWidget* parent = nullptr);

    /// There is no table where there are no rows.
    void hideWhereEmpty();
    void showSpread(const PartSpread& spread) override;
    void clearSpread(bool another) override;

  protected:
    QString warning() const override;
    void showEvent(QShowEvent* event) override;
    void showPart(const Content& content) override;
    void showReference(const Content* content, const QString& name) override;
};

/// Lines of text.
class PartText : public AnswerLabel, public PartView {
    Q_OBJECT

  public:
    PartText(SceneModel* model, std::string_view id, QWidget* parent = nullptr);

    void showSpread(const PartSpread& /*spread*/) override {}
    void clearSpread(bool /*another*/) override {}

  protected:
    void showEvent(QShowEvent* event) override;
    void showPart(const Content& content) override;
    void showReference(const Content* /*content*/, const QString& /*name*/) override {}
};

}  // namespace ravnoves
