#pragma once

#include <QDialog>
#include <string>

class QCheckBox;
class QComboBox;
class QLabel;

namespace ravnoves {

class PlotView;
class ResultTable;
class ScenePage;
class StudyModel;
class SweepView;
class TableEditor;

/// How sure the results of a page are, and what matters most: tolerances of its inputs, the results
/// to watch, and what follows, in a window of its own that follows the page.
class ToleranceWindow : public QDialog {
    Q_OBJECT

  public:
    ToleranceWindow(ScenePage* page, QWidget* parent);

    const ScenePage* page() const { return page_; }
    StudyModel* model() const { return model_; }
    TableEditor* inputs() const { return inputs_; }
    TableEditor* watched() const { return watched_; }
    /// Closing loses rejected texts, so it asks first.
    void reject() override;

  Q_SIGNALS:
    /// The case of the page is to be saved, by Ctrl+S.
    void saveWanted();

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* makeInputs();
    QWidget* makeAnswers();
    void addKeys();
    /// Watches a result, and moves to its limits.
    void watch(const std::string& pointer);
    void showTitle();
    void showStudy();
    void showAnswers();
    void showFound();
    void showChosen();

    ScenePage* page_;
    StudyModel* model_;
    TableEditor* inputs_ = nullptr;
    TableEditor* watched_ = nullptr;
    QCheckBox* bands_ = nullptr;
    QComboBox* method_ = nullptr;
    QComboBox* samples_ = nullptr;
    ResultTable* table_ = nullptr;
    QLabel* words_ = nullptr;
    ResultTable* tornado_ = nullptr;
    PlotView* histogram_ = nullptr;
    SweepView* sweep_ = nullptr;
};

}  // namespace ravnoves
