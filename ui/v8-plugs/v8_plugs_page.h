#pragma once

#include <QMap>
#include <functional>
#include <optional>
#include <vector>

#include "shell/scene_page.h"
#include "v8-plugs/case_input.h"
#include "v8-plugs/journal.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPrinter;
class QPushButton;
class QScrollArea;
class QTabWidget;

namespace ravnoves {

class CheckedField;
class FormSection;
class NumberField;
class PlotView;
class PlugView;
class ResultTable;
class V8PlugsViewModel;
class WeighInSheet;

/// The V-8 workshop page: the sheets of the job to the left, the answer with its options, bob
/// weights, plug and plots to the right; journal and job card in the toolbar.
///
/// Made for hands that are not clean: fields are large, Tab and Enter go down the sheet and on to
/// the next, and every action has a key.
class V8PlugsPage : public ScenePage {
    Q_OBJECT

  public:
    explicit V8PlugsPage(QWidget* parent = nullptr);
    V8PlugsPage(const QString& journalPath, QWidget* parent);

    SceneViewModel* model() override;
    V8PlugsViewModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override;
    QString resultsAsText() const override;
    QString resultsAsCsv() const override;
    void setActive(bool active) override;
    void resetZoom() override;

    /// Opens the journal and offers drafts that a crash left; happens by itself once shown.
    void openJournal();

    // For tests.
    QTabWidget* sheets() const { return sheets_; }
    PlotView* compensationPlot() const { return compensation_; }
    PlotView* shiftPlot() const { return shift_; }
    /// The fields of a sheet in the order of Enter.
    QList<QWidget*> fieldsOf(int sheet) const { return order_.value(sheet); }
    QString writeCard(const QString& file);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* buildSheets();
    QWidget* buildJobSheet();
    QWidget* buildEngineSheet();
    QWidget* buildPlugSheet();
    QWidget* buildMachineSheet();
    QWidget* buildAnswer();
    void buildActions();
    QWidget* addSheet(QWidget* form, const QString& title, const QList<QWidget*>& order);
    /// A number of the input: its field, where it is read, how it is changed.
    NumberField* number(FormSection* section, const QString& label, const FieldSpec& spec,
                        const QString& hint, std::function<std::optional<double>()> read,
                        std::function<void(v8_plugs::CaseInput&, std::optional<double>)> write);
    QLineEdit* text(FormSection* section, const QString& label, const QString& name,
                    std::string v8_plugs::JobHeader::*member, const QString& hint);
    void goOn(QWidget* from);
    void showInput();
    void showEngines();
    void showAnswer();
    void showPlots();
    void showBanner();
    bool leaveJob();
    void saveJob();
    void showJournal();
    void newJob();
    void saveEngine();
    void printCard();
    void previewCard();
    void exportCard();
    void paintCard(QPrinter* printer);

    V8PlugsViewModel* model_;
    std::vector<std::function<void()>> readers_;  // show the input in its field
    QMap<int, QList<QWidget*>> order_;
    QTabWidget* sheets_ = nullptr;
    bool journalTried_ = false;

    QWidget* banner_ = nullptr;
    QLabel* bannerText_ = nullptr;
    QPushButton* bannerContinue_ = nullptr;
    QPushButton* bannerDiscard_ = nullptr;
    QPushButton* bannerClose_ = nullptr;
    QList<JournalDraft> crashed_;

    QComboBox* engine_ = nullptr;
    QPushButton* removeEngine_ = nullptr;
    QLabel* engineNote_ = nullptr;
    QComboBox* crankshaft_ = nullptr;
    QCheckBox* aluminium_ = nullptr;
    QCheckBox* newDesign_ = nullptr;
    WeighInSheet* weighIn_ = nullptr;
    QLabel* plugWeight_ = nullptr;
    QLabel* iso_ = nullptr;
    ResultTable* planes_ = nullptr;

    QLabel* excess_ = nullptr;
    QLabel* advice_ = nullptr;
    QLabel* boring_ = nullptr;
    QLabel* hang_ = nullptr;
    QLabel* troubles_ = nullptr;
    ResultTable* options_ = nullptr;
    ResultTable* bobWeights_ = nullptr;
    QLabel* check_ = nullptr;
    QLabel* shiftNote_ = nullptr;
    PlugView* plug_ = nullptr;
    PlotView* compensation_ = nullptr;
    PlotView* shift_ = nullptr;
    std::vector<int> optionCurves_;
    int ownShift_ = 0;
    double shownReach_ = 0.0;

    QList<QAction*> actions_;
};

}  // namespace ravnoves
